// Vulkan's objects, destroyed when their owner is, and its results, thrown when they are bad.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <vulkan/vulkan.h>

#include "vulkan/compute.h"

namespace sheer::test {

inline void check(VkResult result, const std::string& call)
{
    if (result == VK_SUCCESS) return;
    throw std::runtime_error(call + " failed: VkResult " + std::to_string(result));
}

struct Instance {
    Instance()
    {
        VkApplicationInfo application{};
        application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
        application.apiVersion = VK_API_VERSION_1_1;
        VkInstanceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
        info.pApplicationInfo = &application;
        const VkResult result = vkCreateInstance(&info, nullptr, &handle);
        if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
            throw NoVulkanDevice("no Vulkan device: no driver is installed");
        check(result, "vkCreateInstance");
    }
    ~Instance() { vkDestroyInstance(handle, nullptr); }
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    VkInstance handle = VK_NULL_HANDLE;
};

// A handle that the device made and destroys.
template <class Handle, void (*kDestroy)(VkDevice, Handle, const VkAllocationCallbacks*)>
class Owned {
public:
    Owned(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
    template <class Create, class Info>
    Owned(VkDevice device, const char* call, Create create, const Info& info) : device_(device)
    {
        check(create(device, &info, nullptr, &handle_), call);
    }
    ~Owned() { kDestroy(device_, handle_, nullptr); }
    Owned(Owned&& other) noexcept
        : device_(other.device_), handle_(std::exchange(other.handle_, Handle{}))
    {
    }
    Owned& operator=(Owned&&) = delete;

    const Handle& operator*() const { return handle_; }

private:
    VkDevice device_;
    Handle handle_{};
};

using Buffer = Owned<VkBuffer, vkDestroyBuffer>;
using Memory = Owned<VkDeviceMemory, vkFreeMemory>;
using SetLayout = Owned<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using PipelineLayout = Owned<VkPipelineLayout, vkDestroyPipelineLayout>;
using Shader = Owned<VkShaderModule, vkDestroyShaderModule>;
using Pipeline = Owned<VkPipeline, vkDestroyPipeline>;
using DescriptorPool = Owned<VkDescriptorPool, vkDestroyDescriptorPool>;
using CommandPool = Owned<VkCommandPool, vkDestroyCommandPool>;

// A storage buffer that the host sees, for as long as one run takes.
class HostBuffer {
public:
    HostBuffer(VkPhysicalDevice physical, VkDevice device, std::span<const std::uint32_t> words)
        : buffer_(device, "vkCreateBuffer", vkCreateBuffer, buffer_info(words)),
          memory_(device, "vkAllocateMemory", vkAllocateMemory,
                  memory_info(physical, device, *buffer_))
    {
        check(vkBindBufferMemory(device, *buffer_, *memory_, 0), "vkBindBufferMemory");
        check(vkMapMemory(device, *memory_, 0, VK_WHOLE_SIZE, 0, &mapped_), "vkMapMemory");
        if (!words.empty()) std::memcpy(mapped_, words.data(), words.size_bytes());
    }

    VkBuffer handle() const { return *buffer_; }
    void read(std::span<std::uint32_t> words) const
    {
        if (!words.empty()) std::memcpy(words.data(), mapped_, words.size_bytes());
    }

private:
    static VkBufferCreateInfo buffer_info(std::span<const std::uint32_t> words)
    {
        VkBufferCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
        info.size = std::max<std::size_t>(words.size_bytes(), 4);  // Vulkan has no empty buffers
        info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
        return info;
    }

    static VkMemoryAllocateInfo memory_info(VkPhysicalDevice physical, VkDevice device,
                                            VkBuffer buffer)
    {
        VkMemoryRequirements needed;
        vkGetBufferMemoryRequirements(device, buffer, &needed);
        VkPhysicalDeviceMemoryProperties memory;
        vkGetPhysicalDeviceMemoryProperties(physical, &memory);
        constexpr VkMemoryPropertyFlags kHost =
            VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
        VkMemoryAllocateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
        info.allocationSize = needed.size;
        for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
            info.memoryTypeIndex = i;
            if ((needed.memoryTypeBits >> i & 1u) != 0 &&
                (memory.memoryTypes[i].propertyFlags & kHost) == kHost)
                return info;
        }
        throw std::runtime_error("the Vulkan device has no memory that the host sees");
    }

    Buffer buffer_;
    Memory memory_;
    void* mapped_ = nullptr;
};

}  // namespace sheer::test
