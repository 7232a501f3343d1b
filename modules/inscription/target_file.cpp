#include "target_file.hpp"

#include <algorithm>

#include "baked/baked_writer.hpp"
#include "dilate.hpp"
#include "orbweaver/fault.hpp"

namespace orbweaver::inscription {

namespace {

/// The section "target".
struct Record {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t dilation = kDilation;
    std::uint32_t builder = kTargetBuilder;
};

[[noreturn]] void refuse(const BakedFile& file, const std::string& what) {
    throw Fault(FaultKind::invalid,
                file.path() + ": is unsound: " + what + "; bake it again with orbweaver-assets");
}

const Record& record_in(const BakedFile& file) {
    const auto records = file.section<Record>("target");
    if (records.size() != 1)
        refuse(file, "target has " + std::to_string(records.size()) + " records; expected 1");
    return records[0];
}

bool is_blank(std::span<const std::uint8_t> pixels) {
    return std::find(pixels.begin(), pixels.end(), 1) == pixels.end();
}

bool in_range(std::uint32_t side) { return side >= kSmallestSide && side <= kLargestSide; }

std::span<const std::uint8_t> pixels(const BakedFile& file, const char* name, std::size_t expected) {
    const auto values = file.section<std::uint8_t>(name);
    if (values.size() != expected)
        refuse(file, std::string(name) + " has " + std::to_string(values.size()) + " pixels; expected " +
                         std::to_string(expected));
    std::uint8_t all = 0;
    for (const std::uint8_t value : values) all |= value;
    if (all > 1) refuse(file, std::string(name) + " has values other than 0 and 1");
    return values;
}

}  // namespace

void write_target(const std::string& path, const Bitmap& coverage, const ContentHash& source,
                  const std::string& recipe) {
    if (is_blank(coverage.values))
        throw Fault(FaultKind::invalid,
                    path +
                        ": nothing in it would be dark; expected something to be inscribed, so "
                        "name other words, another picture or more gaps");
    const Bitmap dilated = dilate(coverage, kDilation);
    BakedWriter writer(kTargetType, kTargetVersion, source);
    writer.add_record("target", Record{coverage.width, coverage.height});
    writer.add("coverage", std::span<const std::uint8_t>(coverage.values));
    writer.add("dilated", std::span<const std::uint8_t>(dilated.values));
    writer.add("recipe", std::span<const char>(recipe));
    writer.write(path);
}

Target target_in(const BakedFile& file) {
    const Record& record = record_in(file);
    if (!in_range(record.width) || !in_range(record.height))
        refuse(file, "it has " + std::to_string(record.width) + " x " + std::to_string(record.height) +
                         " pixels; expected sides of " + std::to_string(kSmallestSide) + " to " +
                         std::to_string(kLargestSide));
    if (record.dilation != kDilation)
        refuse(file, "it is dilated by " + std::to_string(record.dilation) + " pixels; expected " +
                         std::to_string(kDilation));
    const std::size_t count = static_cast<std::size_t>(record.width) * record.height;
    return {record.width, record.height, pixels(file, "coverage", count), pixels(file, "dilated", count)};
}

std::string_view recipe_in(const BakedFile& file) {
    const auto text = file.section<char>("recipe");
    return {text.data(), text.size()};
}

std::uint32_t builder_in(const BakedFile& file) { return record_in(file).builder; }

void verify_target(const BakedFile& file) {
    const Target target = target_in(file);
    Bitmap coverage(target.width, target.height);
    std::copy(target.coverage.begin(), target.coverage.end(), coverage.values.begin());
    if (is_blank(coverage.values)) refuse(file, "nothing in its coverage is dark");
    const Bitmap dilated = dilate(coverage, kDilation);
    const auto differs = std::mismatch(dilated.values.begin(), dilated.values.end(), target.dilated.begin());
    if (differs.first == dilated.values.end()) return;
    const auto at = static_cast<std::size_t>(differs.first - dilated.values.begin());
    refuse(file, "dilated is wrong at pixel " + std::to_string(at % target.width) + ", " +
                     std::to_string(at / target.width));
}

}  // namespace orbweaver::inscription
