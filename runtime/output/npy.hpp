#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "output/atomic_file.hpp"

namespace orbweaver {

/// A NumPy .npy file (format 1.0, C order, little endian) that grows by one row of a fixed shape at a time.
class NpyWriter {
public:
    /// `type` as NumPy writes it ("<f8", "<u8"); `row_shape` is the shape behind the first axis.
    NpyWriter(const std::string& path, std::string type, std::vector<std::size_t> row_shape);

    void append(const void* row, std::size_t bytes);
    void commit();
    std::size_t rows() const noexcept { return rows_; }

private:
    std::string header() const;

    AtomicFile file_;
    std::string type_;
    std::vector<std::size_t> row_shape_;
    std::size_t rows_ = 0;
};

}  // namespace orbweaver
