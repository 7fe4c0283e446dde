// A new buffer with the contents of a vector; of one element where the vector is empty, since there is no buffer of nothing.
#pragma once

#include <algorithm>
#include <vector>

#include "gpu/recorder.h"

namespace gnomon {

template <class T>
Buffer upload_vector(Device& device, const char* name, const std::vector<T>& values, VkBufferUsageFlags usage = 0) {
  Buffer buffer(device, name, std::max<size_t>(values.size() * sizeof(T), sizeof(T)), BufferMemory::device, usage);
  upload(device, buffer, std::as_bytes(std::span(values)));
  return buffer;
}

}  // namespace gnomon
