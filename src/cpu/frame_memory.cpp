// Bounds from above: a limit is kept, not estimated.
#include "cpu/frame_memory.h"

#include <algorithm>
#include <vector>

#include "geometry/pose.h"

namespace sheer {

// At most: posed vertices, and triangles in chunks that grow, none of them culled.
std::uint64_t geometry_bytes(const Scene& scene, const PlaceSpaces& places)
{
    const bool textured = std::any_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& m) {
        return !m.texcoords[0].empty() || !m.texcoords[1].empty() || !m.tangents.empty();
    });
    const auto spaces = static_cast<std::size_t>(std::count(places.begin(), places.end(), true));
    const std::size_t attribute_bytes =
        sizeof(Attributes) + (textured ? sizeof(TextureAttributes) : 0) + spaces * sizeof(Float3);
    const std::size_t vertex_bytes = sizeof(PosedVertex) + attribute_bytes;
    constexpr std::size_t kTriangleBytes = 2 * sizeof(Triangle) + 4 * sizeof(std::uint32_t);
    // Of a ribbon or square on its way, which is a mesh of its own.
    constexpr std::size_t kMadeBytes =
        3 * (2 * sizeof(Float3) + sizeof(Float4) + 2 * sizeof(Float2));
    std::uint64_t bytes = 0;
    for (const Object& object : scene.objects) {
        const Mesh& mesh = scene.meshes[object.mesh];
        const std::size_t indices = mesh.indices.size();
        switch (mesh.topology) {
            case Topology::triangles:
                bytes += mesh.positions.size() * vertex_bytes + indices / 3 * kTriangleBytes;
                // Vertices of their own, in a vector that grows.
                if (mesh.normals.empty()) bytes += 2 * indices * attribute_bytes;
                // Tangents on their way.
                if (mesh.tangents.empty() && material_of(scene, object).normal_texture) {
                    bytes += mesh.positions.size() * (9 * sizeof(double) + sizeof(Float4));
                }
                break;
            case Topology::lines:
                bytes += indices * (2 * (vertex_bytes + kMadeBytes) + kTriangleBytes);
                break;
            case Topology::points:
                bytes += indices * (4 * (vertex_bytes + kMadeBytes) + 2 * kTriangleBytes);
                break;
        }
    }
    return bytes;
}

namespace {

std::size_t most_triangles_of_a_tile(const Geometry& geometry, int tiles)
{
    std::vector<std::size_t> counts(static_cast<std::size_t>(tiles));
    for (const TriangleChunk& chunk : geometry.chunks) {
        for (std::size_t t = 0; t + 1 < chunk.tile_begin.size(); ++t) {
            counts[t] += chunk.tile_begin[t + 1] - chunk.tile_begin[t];
        }
    }
    return counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
}

// Of one thread, but for the stores that grow. A vector that grows holds its old contents beside
// the new for a while: three times what it was.
std::size_t thread_bytes(const FrameJob& job)
{
    const auto samples = static_cast<std::size_t>(job.samples.count);
    const std::size_t pixel_samples = kTilePixels * samples;
    const std::size_t per_fragment =
        sizeof(FragmentRun) + (any_placed(job.groups) ? 29 : 19) * sizeof(float);
    std::size_t bytes = static_cast<std::size_t>(job.stream_capacity) * per_fragment +
                        pixel_samples * sizeof(Float4) + kTilePixels * 10 * sizeof(Float4);
    const std::size_t triangles = most_triangles_of_a_tile(job.geometry, job.grid.count());
    bytes += triangles * 3 * sizeof(TileTriangle);
    if (job.surfaces.any_opaque) {
        bytes += pixel_samples * 6 * sizeof(float) + triangles * 3 * sizeof(OpaqueSurface);
    }
    const bool sorts = std::any_of(
        job.groups.begin(), job.groups.end(),
        [](const TakeGroup& group) { return group.wants.submission != Submission::as_given; });
    if (sorts) bytes += triangles * 4 * sizeof(SortedTriangle);  // and what stable_sort takes
    bool divides = false;
    for (const Take& take : job.takes) {
        const MethodTraits traits = take.method.traits();
        divides = divides || traits.divides;
        bytes += static_cast<std::size_t>(traits.bytes_per_streamed) *
                 static_cast<std::size_t>(job.stream_capacity);
        if (!traits.bounded) continue;
        bytes +=
            kTilePixels * static_cast<std::size_t>(traits.bytes_per_pixel(job.samples.count, 0));
    }
    if (divides) bytes += pixel_samples * 5 * sizeof(float);  // SampleColors::fraction
    if (job.shading.foveation != nullptr) bytes += FoveationScratch::bytes();
    return bytes;
}

}  // namespace

MemoryPlan plan_frame_memory(FrameJob& job, const Options& options, std::uint64_t reserved,
                             int threads)
{
    MemoryNeeds needs{.limit = options.memory_limit,
                      .pixels = static_cast<std::uint64_t>(job.grid.width) *
                                static_cast<std::uint64_t>(job.grid.height),
                      .pictures = options.channels ? 1u : 0u,
                      .thread_bytes = thread_bytes(job),
                      .growing_stores = 0,
                      .threads = threads,
                      .reserved = reserved};
    for (const Take& take : job.takes) {
        const MethodTraits traits = take.method.traits();
        // The post filter makes one of the transparent part, and needs that.
        needs.pictures += (take.variance ? 2u : 1u) + (take.transparent ? 2u : 0u);
        if (take.apart && traits.divides) needs.pictures += 2;  // 20 bytes a pixel
        if (!traits.bounded) ++needs.growing_stores;
        needs.reserved += static_cast<std::uint64_t>(traits.bytes_of_tables);
    }
    if (needs.limit != 0 && memory_needed(needs) > needs.limit) {
        job.stream_capacity = kStreamFragments;
        needs.thread_bytes = thread_bytes(job);
    }
    return plan_memory(needs);
}

}  // namespace sheer
