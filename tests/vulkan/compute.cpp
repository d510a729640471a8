// The objects that one dispatch needs, made for each run anew: simple before fast.
#include "vulkan/compute.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>

#include <vulkan/vulkan.h>

#include "support/read_file.h"
#include "vulkan/handles.h"

namespace sheer::test {
namespace {

std::vector<std::uint32_t> read_spirv(const std::string& path)
{
    const Bytes bytes = read_file(path);
    if (bytes.empty() || bytes.size() % 4 != 0) throw std::runtime_error(path + ": is no SPIR-V");
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

std::optional<std::uint32_t> compute_family(VkPhysicalDevice physical)
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    for (std::uint32_t i = 0; i < count; ++i)
        if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) return i;
    return std::nullopt;
}

VkPhysicalDeviceProperties properties_of(VkPhysicalDevice physical)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    return properties;
}

bool is_cpu(VkPhysicalDevice physical)
{
    return properties_of(physical).deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

VkPhysicalDevice best_device(VkInstance instance)
{
    std::uint32_t count = 0;
    const VkResult result = vkEnumeratePhysicalDevices(instance, &count, nullptr);
    if (result == VK_ERROR_INITIALIZATION_FAILED)
        throw NoVulkanDevice("no Vulkan device: no driver could begin");
    check(result, "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> all(count);
    check(vkEnumeratePhysicalDevices(instance, &count, all.data()), "vkEnumeratePhysicalDevices");
    std::erase_if(all, [](VkPhysicalDevice physical) {
        return properties_of(physical).apiVersion < VK_API_VERSION_1_1 || !compute_family(physical);
    });
    if (all.empty()) throw NoVulkanDevice("no Vulkan device: none has Vulkan 1.1 and compute");
    const auto software = std::find_if(all.begin(), all.end(), is_cpu);
    return software != all.end() ? *software : all.front();
}

}  // namespace

struct ComputeDevice::Device {
    Device()
    {
        VkPhysicalDeviceFeatures available;
        vkGetPhysicalDeviceFeatures(physical, &available);
        VkPhysicalDeviceFeatures wanted{};
        wanted.shaderFloat64 = available.shaderFloat64;
        wanted.shaderInt64 = available.shaderInt64;

        const float priority = 1;
        VkDeviceQueueCreateInfo queue_info{};
        queue_info.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        queue_info.queueFamilyIndex = family;
        queue_info.queueCount = 1;
        queue_info.pQueuePriorities = &priority;
        VkDeviceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queue_info;
        info.pEnabledFeatures = &wanted;
        check(vkCreateDevice(physical, &info, nullptr, &handle), "vkCreateDevice");
        vkGetDeviceQueue(handle, family, 0, &queue);
    }
    ~Device() { vkDestroyDevice(handle, nullptr); }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    Instance instance;
    VkPhysicalDevice physical = best_device(instance.handle);
    std::uint32_t family = compute_family(physical).value();
    VkDevice handle = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
};

namespace {

SetLayout make_set_layout(VkDevice device, std::size_t buffers)
{
    std::vector<VkDescriptorSetLayoutBinding> bindings(buffers);
    for (std::uint32_t i = 0; i < buffers; ++i) {
        bindings[i].binding = i;
        bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        bindings[i].descriptorCount = 1;
        bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
    }
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    return {device, "vkCreateDescriptorSetLayout", vkCreateDescriptorSetLayout, info};
}

PipelineLayout make_pipeline_layout(VkDevice device, const SetLayout& set_layout)
{
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &*set_layout;
    return {device, "vkCreatePipelineLayout", vkCreatePipelineLayout, info};
}

Pipeline make_pipeline(VkDevice device, const PipelineLayout& layout, const std::string& path,
                       std::span<const SpecializationConstant> constants)
{
    const std::vector<std::uint32_t> code = read_spirv(path);
    VkShaderModuleCreateInfo shader_info{};
    shader_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    shader_info.codeSize = 4 * code.size();
    shader_info.pCode = code.data();
    const Shader shader(device, "vkCreateShaderModule", vkCreateShaderModule, shader_info);

    std::vector<VkSpecializationMapEntry> entries;
    for (const SpecializationConstant& constant : constants) {
        const std::size_t offset = entries.size() * sizeof(SpecializationConstant) +
                                   offsetof(SpecializationConstant, value);
        entries.push_back({constant.id, static_cast<std::uint32_t>(offset), 4});
    }
    VkSpecializationInfo specialization{};
    specialization.mapEntryCount = static_cast<std::uint32_t>(entries.size());
    specialization.pMapEntries = entries.data();
    specialization.dataSize = constants.size_bytes();
    specialization.pData = constants.data();

    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = *shader;
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = &specialization;
    info.layout = *layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "vkCreateComputePipelines of " + path);
    return {device, pipeline};
}

DescriptorPool make_descriptor_pool(VkDevice device, std::size_t buffers)
{
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                    static_cast<std::uint32_t>(buffers)};
    VkDescriptorPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.maxSets = 1;
    info.poolSizeCount = 1;
    info.pPoolSizes = &size;
    return {device, "vkCreateDescriptorPool", vkCreateDescriptorPool, info};
}

// Freed with its pool.
VkDescriptorSet make_descriptor_set(VkDevice device, const DescriptorPool& pool,
                                    const SetLayout& layout, std::span<const HostBuffer> buffers)
{
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = *pool;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &*layout;
    VkDescriptorSet set = VK_NULL_HANDLE;
    check(vkAllocateDescriptorSets(device, &info, &set), "vkAllocateDescriptorSets");
    for (std::uint32_t i = 0; i < buffers.size(); ++i) {
        const VkDescriptorBufferInfo whole{buffers[i].handle(), 0, VK_WHOLE_SIZE};
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set;
        write.dstBinding = i;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &whole;
        vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
    }
    return set;
}

CommandPool make_command_pool(VkDevice device, std::uint32_t family)
{
    VkCommandPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    info.queueFamilyIndex = family;
    return {device, "vkCreateCommandPool", vkCreateCommandPool, info};
}

// Freed with its pool.
VkCommandBuffer begin_commands(VkDevice device, const CommandPool& pool)
{
    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = *pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device, &info, &commands), "vkAllocateCommandBuffers");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    return commands;
}

void end_and_wait(VkQueue queue, VkCommandBuffer commands)
{
    VkMemoryBarrier to_host{};
    to_host.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    to_host.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    to_host.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                         0, 1, &to_host, 0, nullptr, 0, nullptr);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    check(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
}

}  // namespace

ComputeDevice::ComputeDevice() : device_(std::make_unique<Device>()) {}
ComputeDevice::~ComputeDevice() = default;

std::string ComputeDevice::name() const
{
    return properties_of(device_->physical).deviceName;
}

bool ComputeDevice::is_software() const
{
    return is_cpu(device_->physical);
}

void ComputeDevice::run(const std::string& spirv_path,
                        std::span<const SpecializationConstant> constants,
                        std::span<std::vector<std::uint32_t>> buffers,
                        std::array<std::uint32_t, 3> groups)
{
    VkDevice device = device_->handle;
    std::vector<HostBuffer> on_device;
    for (const auto& words : buffers) on_device.emplace_back(device_->physical, device, words);

    const SetLayout set_layout = make_set_layout(device, buffers.size());
    const PipelineLayout layout = make_pipeline_layout(device, set_layout);
    const Pipeline pipeline = make_pipeline(device, layout, spirv_path, constants);
    const DescriptorPool descriptors = make_descriptor_pool(device, buffers.size());
    const VkDescriptorSet set = make_descriptor_set(device, descriptors, set_layout, on_device);
    const CommandPool command_pool = make_command_pool(device, device_->family);
    VkCommandBuffer commands = begin_commands(device, command_pool);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, *pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, *layout, 0, 1, &set, 0,
                            nullptr);
    vkCmdDispatch(commands, groups[0], groups[1], groups[2]);
    end_and_wait(device_->queue, commands);

    for (std::size_t i = 0; i < buffers.size(); ++i) on_device[i].read(buffers[i]);
}

}  // namespace sheer::test
