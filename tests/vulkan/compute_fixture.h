// Tests with a Vulkan device; skipped where there is none.
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "vulkan/compute.h"

namespace sheer::test {

// "NAME.comp" of this folder, compiled; without a suffix.
inline std::string shader_file(const std::string& name)
{
    return std::string(SHEER_SHADERS "/") + name + ".spv";
}

class VulkanTest : public testing::Test {
protected:
    void SetUp() override
    {
        try {
            device = std::make_unique<ComputeDevice>();
        } catch (const NoVulkanDevice& error) {
            GTEST_SKIP() << error.what();
        }
    }

    std::unique_ptr<ComputeDevice> device;
};

// Tests that compare bits with C++'s.
class VulkanBits : public VulkanTest {
protected:
    void SetUp() override
    {
        VulkanTest::SetUp();
        if (device && !device->is_software())
            GTEST_SKIP() << device->name() << " may divide less precisely than C++ does";
    }
};

}  // namespace sheer::test
