#pragma once

#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/folder.hpp"

namespace orbweaver::test {

/// A .npy file as the format's own page describes version 1.0, read without the writer's help.
struct Npy {
    std::string type;
    std::vector<std::size_t> shape;
    std::string data;

    explicit Npy(const std::string& path) {
        const std::string bytes = read_file(path);
        const auto demand = [&](bool good, const char* what) {
            if (!good) throw std::runtime_error(path + ": " + what);
        };
        demand(bytes.size() >= 10 && bytes.compare(0, 8, std::string("\x93NUMPY\x01\x00", 8)) == 0,
               "magic or version");
        const std::size_t length =
            static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
        demand((10 + length) % 64 == 0, "the header's end is not aligned");
        demand(bytes.size() >= 10 + length, "cut header");
        const std::string header = bytes.substr(10, length);
        demand(header.back() == '\n', "no line end behind the header");
        demand(header.find("'fortran_order': False") != std::string::npos, "not in C order");
        type = between(header, "'descr': '", "'");
        std::stringstream axes(between(header, "'shape': (", ")"));
        for (std::string axis; std::getline(axes, axis, ',');)
            if (axis.find_first_of("0123456789") != std::string::npos) shape.push_back(std::stoul(axis));
        data = bytes.substr(10 + length);
        std::size_t size = std::stoul(type.substr(2));
        for (const std::size_t axis : shape) size *= axis;
        demand(data.size() == size, "the data have not the size of the shape");
    }

    template <class T>
    std::vector<T> values() const {
        std::vector<T> all(data.size() / sizeof(T));
        if (!all.empty()) std::memcpy(all.data(), data.data(), data.size());
        return all;
    }

private:
    static std::string between(const std::string& text, const std::string& first, const char* last) {
        const auto begin = text.find(first);
        if (begin == std::string::npos) throw std::runtime_error("no " + first);
        const auto from = begin + first.size();
        return text.substr(from, text.find(last, from) - from);
    }
};

}  // namespace orbweaver::test
