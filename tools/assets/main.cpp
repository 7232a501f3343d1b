#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "bake.hpp"
#include "baked_commands.hpp"
#include "cli/picture_size.hpp"
#include "cli/program.hpp"
#include "mesh_commands.hpp"
#include "orbweaver/build_stamp.hpp"
#include "output/atomic_file.hpp"
#include "picture/png.hpp"
#include "sky.hpp"
#include "target_command.hpp"

namespace {

using namespace orbweaver;

constexpr int kUsage = 2;

void write_sky(const std::string& path, const std::string& size, std::uint64_t seed) {
    const auto asked = parse_picture_size(size);
    if (!asked || asked->height < 16 || asked->height > 4096 || asked->width != 2 * asked->height)
        throw CLI::ValidationError(
            "--size",
            fmt::format("'{}' is not the size of a sky; expected WxH, twice as wide as high, 16 to 4096 high",
                        size));
    const auto sky = make_sky({asked->width, asked->height, seed});
    const auto png = picture::encode_png(sky.width, sky.height, sky.rgb, picture::PngEffort::small);
    AtomicFile file(path);
    file.write(png.data(), png.size());
    file.commit();
    fmt::print("{}: {} x {} pixels\n", path, sky.width, sky.height);
}

int command_line(int argc, char** argv) {
    CLI::App app{"Makes ready and makes up the assets that Orbweaver's scenes ask for"};
    app.set_version_flag("--version", kVersion);
    app.require_subcommand(1);

    std::string scene;
    std::vector<std::string> modules;
    auto* bake = app.add_subcommand("bake", "make ready everything that a scene asks for");
    bake->add_option("SCENE", scene, "the scene, a TOML file")->required();
    bake->add_option("--modules", modules, "search this folder for modules first; repeatable")
        ->allow_extra_args(false);

    std::string output;
    std::string size = "2048x1024";
    std::uint64_t seed = 1;
    auto* sky = app.add_subcommand("sky", "paint a meadow under a morning sky, equirectangular, as PNG");
    sky->add_option("-o,--output", output, "the file to write")->required();
    sky->add_option("--size", size, "pixels, WxH, twice as wide as high")->capture_default_str();
    sky->add_option("--seed", seed, "another seed, another meadow")->capture_default_str();
    const AdjacencyCommand adjacency(app);
    const InspectCommand inspect(app);
    const VerifyCommand verify(app);
    const MeshCommand mesh(app);
    const TargetCommand target(app);
    try {
        app.parse(argc, argv);
        if (adjacency.parsed()) return adjacency.run();
        if (inspect.parsed()) return inspect.run();
        if (verify.parsed()) return verify.run();
        if (mesh.parsed()) return mesh.run();
        if (target.parsed()) return target.run();
        if (bake->parsed()) return bake_scene(scene, modules);
        write_sky(output, size, seed);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kUsage;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return orbweaver::guarded_main([&] { return command_line(argc, argv); });
}
