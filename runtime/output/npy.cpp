#include "output/npy.hpp"

#include <fmt/format.h>

#include <bit>

namespace orbweaver {

static_assert(std::endian::native == std::endian::little, "the .npy headers written here say little endian");

NpyWriter::NpyWriter(const std::string& path, std::string type, std::vector<std::size_t> row_shape)
    : file_(path), type_(std::move(type)), row_shape_(std::move(row_shape)) {
    file_.write(header());
}

std::string NpyWriter::header() const {
    constexpr std::size_t kHeaderBytes = 128;  // a multiple of 64, wide enough for any row count
    std::string shape = fmt::format("{},", rows_);
    for (const std::size_t axis : row_shape_) shape += fmt::format(" {},", axis);
    std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type_, shape);
    constexpr std::size_t kTextBytes = kHeaderBytes - 10;
    text.resize(kTextBytes - 1, ' ');
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(kTextBytes & 0xff);
    bytes += static_cast<char>(kTextBytes >> 8);
    return bytes + text + "\n";
}

void NpyWriter::append(const void* row, std::size_t bytes) {
    file_.write(row, bytes);
    ++rows_;
}

void NpyWriter::commit() {
    file_.rewrite_front(header());
    file_.commit();
}

}  // namespace orbweaver
