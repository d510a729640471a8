// Compute shaders from the tests, one dispatch at a time: the least of Vulkan that does it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace sheer::test {

// Thrown where there is nothing to run on; whatever else goes wrong is a plain runtime_error.
struct NoVulkanDevice : std::runtime_error {
    using runtime_error::runtime_error;
};

// `layout(constant_id = id) const`; floats by std::bit_cast.
struct SpecializationConstant {
    std::uint32_t id;
    std::uint32_t value;
};

class ComputeDevice {
public:
    // A software device (lavapipe) if there is one, else any other with Vulkan 1.1.
    // Throws NoVulkanDevice.
    ComputeDevice();
    ~ComputeDevice();

    std::string name() const;
    // Whether it is a software device. Others may divide less precisely: Vulkan lets them.
    bool is_software() const;

    // Runs main() of a SPIR-V file over `groups` work groups. buffers[i] is the storage buffer
    // `layout(set = 0, binding = i)`: written to the device before, read back after.
    // Throws std::runtime_error with one line that says what failed.
    void run(const std::string& spirv_path, std::span<const SpecializationConstant> constants,
             std::span<std::vector<std::uint32_t>> buffers, std::array<std::uint32_t, 3> groups);

private:
    struct Device;
    std::unique_ptr<Device> device_;
};

}  // namespace sheer::test
