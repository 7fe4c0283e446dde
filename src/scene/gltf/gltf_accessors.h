// Accessors of a glTF file: typed arrays in buffer views, with sparse changes.
#pragma once

#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/gltf_document.h"

namespace gnomon {

class GltfAccessors {
 public:
  // Checks every accessor of the file, used or not.
  explicit GltfAccessors(GltfDocument& document);

  size_t count() const { return accessors_.size(); }
  size_t element_count(int accessor) const { return at(accessor).count; }
  int components(int accessor) const { return at(accessor).components; }
  // What an integer of a normalised accessor is multiplied with; 1 for others.
  float normalised_scale(int accessor) const;

  // Neither signed nor scaled nor a float.
  bool is_unsigned(int accessor) const;

  // The elements as finite floats, normalised integers scaled to [0, 1] or [-1, 1]. `place`: who asks, for errors.
  // `only`: these elements in this order instead of all. `lost`: counts the elements that are not finite, which become zero;
  // without it they are an error.
  template <int N>
  std::vector<glm::vec<N, float>> floats(int accessor, const std::string& place, const std::vector<uint32_t>* only = nullptr,
                                         size_t* lost = nullptr) const {
    const Accessor& a = at(accessor);
    require_type(a, N, place);
    const size_t size = only ? only->size() : a.count;
    document_.budget().take(size, place);
    std::vector<glm::vec<N, float>> values(size);
    if (size > 0) read_floats(a, only, &values[0][0], lost);
    return values;
  }
  // The components of all elements in one row; 1 to 4, or 16 of matrices.
  std::vector<float> numbers(int accessor, int components, const std::string& place) const;

  // Vertex indices: unsigned integers of any width.
  std::vector<uint32_t> indices(int accessor, const std::string& place) const;

 private:
  struct Sparse {
    size_t count = 0;
    int index_view = 0, value_view = 0;
    uint64_t index_offset = 0, value_offset = 0;
    int index_type = 0;
  };
  struct Accessor {
    std::string place, type;
    int view = -1;
    uint64_t offset = 0;
    int component_type = 0, components = 1;
    size_t element_size = 0, stride = 0, count = 0;
    bool normalised = false;
    std::optional<Sparse> sparse;
  };

  const Accessor& at(int index) const { return accessors_[static_cast<size_t>(index)]; }
  Accessor read_accessor(const GltfValue& json) const;
  Sparse read_sparse(const GltfValue& json, const Accessor& accessor) const;
  void require_type(const Accessor& accessor, int components, const std::string& place) const;
  // The bytes from `offset` on, with room for `count` elements.
  Bytes elements(int view, uint64_t offset, size_t stride, size_t element_size, size_t count, const std::string& place) const;
  std::vector<uint32_t> sparse_indices(const Accessor& accessor) const;
  void read_floats(const Accessor& accessor, const std::vector<uint32_t>* only, float* out, size_t* lost) const;

  GltfDocument& document_;
  std::vector<Accessor> accessors_;
};

}  // namespace gnomon
