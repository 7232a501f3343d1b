#include "import_mesh.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/DefaultIOSystem.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "imported_mesh_bytes.hpp"
#include "orbweaver/fault.hpp"
#include "surface_mesh.hpp"

namespace orbweaver {

namespace {

using mesh::RawMesh;

/// assimp's scene, flattened.
class Flattener {
public:
    explicit Flattener(const aiScene& scene) : scene_(scene), material_(scene.mNumMaterials, mesh::kNone) {}

    RawMesh flatten() {
        std::vector<std::pair<const aiNode*, aiMatrix4x4>> waiting = {{scene_.mRootNode, aiMatrix4x4()}};
        while (!waiting.empty()) {
            const auto [node, parent] = waiting.back();
            waiting.pop_back();
            const aiMatrix4x4 place = parent * node->mTransformation;
            for (unsigned i = 0; i < node->mNumMeshes; ++i) add(*scene_.mMeshes[node->mMeshes[i]], place);
            for (unsigned i = node->mNumChildren; i > 0; --i)
                waiting.emplace_back(node->mChildren[i - 1], place);
        }
        return std::move(raw_);
    }

private:
    void add(const aiMesh& mesh, const aiMatrix4x4& place) {
        const auto base = static_cast<std::uint32_t>(raw_.points.size());
        const std::uint32_t material = number_material(mesh.mMaterialIndex);
        const bool mirrored = place.Determinant() < 0;  // which turns every polygon over: turn them back
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D p = place * mesh.mVertices[i];
            raw_.points.push_back({p.x, p.y, p.z});
        }
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices < 3) continue;  // points and lines
            for (unsigned c = 0; c < face.mNumIndices; ++c)
                raw_.corners.push_back(base + face.mIndices[mirrored ? face.mNumIndices - 1 - c : c]);
            raw_.first.push_back(static_cast<std::uint32_t>(raw_.corners.size()));
            raw_.material.push_back(material);
        }
    }

    /// Only materials that something is made of are kept.
    std::uint32_t number_material(unsigned index) {
        std::uint32_t& number = material_.at(index);
        if (number == mesh::kNone) {
            number = static_cast<std::uint32_t>(raw_.material_names.size());
            const std::string name = scene_.mMaterials[index]->GetName().C_Str();
            raw_.material_names.push_back(name.empty() ? "material " + std::to_string(index) : name);
        }
        return number;
    }

    const aiScene& scene_;
    std::vector<std::uint32_t> material_;  ///< ours for assimp's
    RawMesh raw_;
};

/// Files as always, with a list of those that were read.
class RecordingFiles : public Assimp::DefaultIOSystem {
public:
    explicit RecordingFiles(std::vector<std::string>& read) : read_(read) {}
    Assimp::IOStream* Open(const char* path, const char* mode) override {
        Assimp::IOStream* stream = DefaultIOSystem::Open(path, mode);
        if (stream != nullptr && std::find(read_.begin(), read_.end(), path) == read_.end())
            read_.emplace_back(path);
        return stream;
    }

private:
    std::vector<std::string>& read_;
};

ImportedMesh import_here(const std::string& path) {
    std::vector<std::string> read;
    Assimp::Importer importer;
    importer.SetIOHandler(new RecordingFiles(read));  // which the importer owns
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                                    aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                    aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    const aiScene* scene = importer.ReadFile(path, aiProcess_RemoveComponent);
    const std::string why = importer.GetErrorString();
    if (scene == nullptr && why.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw Fault(
            FaultKind::invalid,
            fmt::format("{}: cannot be imported: {}; export the mesh again, or in another format", path, why));
    std::erase(read, path);
    return {Flattener(*scene).flatten(), std::move(read)};
}

void check_source(const std::string& path) {
    std::error_code error;
    const auto refuse = [&](FaultKind kind, const std::string& what) { throw Fault(kind, path + ": " + what); };
    if (!std::filesystem::exists(path, error))
        refuse(FaultKind::invalid, "there is no such file; name a mesh, such as cube.obj");
    if (!std::filesystem::is_regular_file(path, error))
        refuse(FaultKind::invalid, "is not a regular file; name a mesh, such as cube.obj");
    if (std::ifstream file(path, std::ios::binary); !file)
        refuse(FaultKind::invalid,
               fmt::format("cannot be read: {}; check that it may be", std::strerror(errno)));
    if (const auto size = std::filesystem::file_size(path, error); size > kLargestSource)
        refuse(FaultKind::limit,
               fmt::format("has {} bytes; expected at most {}, so simplify it", size, kLargestSource));
}

}  // namespace

ImportedMesh import_mesh(const std::string& path, const ChildLimits& limits) {
    check_source(path);
    return imported_mesh_from_bytes(run_in_child(path, limits, [&] { return to_bytes(import_here(path)); }),
                                    path);
}

}  // namespace orbweaver
