// Compiled by findings about Vulkan devices. Runs the compute shader "main" of shader.spv once,
// with the numbers of the command line in its buffer 0, and prints the COUNT floats of its
// buffer 1. compute COUNT NUMBER...
#include <stdio.h>
#include <stdlib.h>
#include <vulkan/vulkan.h>

enum { kFloats = 1024 };

int main(int arguments, char** argument) {
  VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                   .apiVersion = VK_API_VERSION_1_1};
  VkInstanceCreateInfo instance_info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                        .pApplicationInfo = &application};
  VkInstance instance;
  VkPhysicalDevice physical;
  uint32_t count = 1;
  if (vkCreateInstance(&instance_info, 0, &instance) != VK_SUCCESS ||
      vkEnumeratePhysicalDevices(instance, &count, &physical) < 0 || count == 0) {
    return 77;
  }
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical, &properties);
  printf("%.11s:", properties.deviceName);

  const float priority = 1;
  VkDeviceQueueCreateInfo queue_info = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1,
                                        .pQueuePriorities = &priority};
  VkDeviceCreateInfo device_info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .queueCreateInfoCount = 1,
                                    .pQueueCreateInfos = &queue_info};
  VkDevice device;
  VkQueue queue;
  vkCreateDevice(physical, &device_info, 0, &device);
  vkGetDeviceQueue(device, 0, 0, &queue);

  VkPhysicalDeviceMemoryProperties memories;
  vkGetPhysicalDeviceMemoryProperties(physical, &memories);
  const VkMemoryPropertyFlags visible =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  VkBuffer buffers[2];
  float* floats[2];
  for (int i = 0; i < 2; ++i) {
    VkBufferCreateInfo buffer_info = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = 4 * kFloats,
                                      .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
    vkCreateBuffer(device, &buffer_info, 0, &buffers[i]);
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, buffers[i], &needs);
    uint32_t type = 0;
    while (!(needs.memoryTypeBits >> type & 1) ||
           (memories.memoryTypes[type].propertyFlags & visible) != visible) {
      ++type;
    }
    VkMemoryAllocateInfo memory_info = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                        .allocationSize = needs.size, .memoryTypeIndex = type};
    VkDeviceMemory memory;
    vkAllocateMemory(device, &memory_info, 0, &memory);
    vkBindBufferMemory(device, buffers[i], memory, 0);
    vkMapMemory(device, memory, 0, VK_WHOLE_SIZE, 0, (void**)&floats[i]);
  }
  for (int i = 2; i < arguments; ++i) floats[0][i - 2] = strtof(argument[i], 0);

  static uint32_t code[65536];
  FILE* file = fopen("shader.spv", "rb");
  VkShaderModuleCreateInfo module_info = {VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                          .pCode = code,
                                          .codeSize = fread(code, 1, sizeof code, file)};
  VkShaderModule module;
  vkCreateShaderModule(device, &module_info, 0, &module);
  VkDescriptorSetLayoutBinding bindings[2] = {
      {0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT},
      {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT}};
  VkDescriptorSetLayoutCreateInfo set_info = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                              .bindingCount = 2, .pBindings = bindings};
  VkDescriptorSetLayout set_layout;
  vkCreateDescriptorSetLayout(device, &set_info, 0, &set_layout);
  VkPipelineLayoutCreateInfo layout_info = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                            .setLayoutCount = 1, .pSetLayouts = &set_layout};
  VkPipelineLayout layout;
  vkCreatePipelineLayout(device, &layout_info, 0, &layout);
  VkComputePipelineCreateInfo pipeline_info = {
      VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
      .stage = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, .pName = "main",
                .module = module, .stage = VK_SHADER_STAGE_COMPUTE_BIT},
      .layout = layout};
  VkPipeline pipeline;
  vkCreateComputePipelines(device, 0, 1, &pipeline_info, 0, &pipeline);
  VkDescriptorPoolSize pool_size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
  VkDescriptorPoolCreateInfo pool_info = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                          .maxSets = 1, .poolSizeCount = 1,
                                          .pPoolSizes = &pool_size};
  VkDescriptorPool pool;
  vkCreateDescriptorPool(device, &pool_info, 0, &pool);
  VkDescriptorSetAllocateInfo allocate_info = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                               .descriptorPool = pool, .descriptorSetCount = 1,
                                               .pSetLayouts = &set_layout};
  VkDescriptorSet set;
  vkAllocateDescriptorSets(device, &allocate_info, &set);
  for (uint32_t i = 0; i < 2; ++i) {
    VkDescriptorBufferInfo whole = {buffers[i], 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                  .dstSet = set,
                                  .dstBinding = i,
                                  .descriptorCount = 1,
                                  .pBufferInfo = &whole,
                                  .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    vkUpdateDescriptorSets(device, 1, &write, 0, 0);
  }
  VkCommandPoolCreateInfo commands_info = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  VkCommandPool commands;
  vkCreateCommandPool(device, &commands_info, 0, &commands);
  VkCommandBufferAllocateInfo command_info = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                              .commandPool = commands, .commandBufferCount = 1};
  VkCommandBuffer command;
  vkAllocateCommandBuffers(device, &command_info, &command);
  VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  vkBeginCommandBuffer(command, &begin);
  vkCmdBindPipeline(command, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
  vkCmdBindDescriptorSets(command, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, 0);
  vkCmdDispatch(command, 1, 1, 1);
  vkEndCommandBuffer(command);
  VkSubmitInfo submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1,
                         .pCommandBuffers = &command};
  vkQueueSubmit(queue, 1, &submit, 0);
  vkQueueWaitIdle(queue);
  for (int i = 0; i < atoi(argument[1]); ++i) printf(" %g", floats[1][i]);
  puts("");
}
