// Accessors of a glTF file: typed arrays in buffer views, with sparse changes.
#include "scene/gltf/gltf_accessors.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

enum ComponentType { k_byte = 5120, k_ubyte = 5121, k_short = 5122, k_ushort = 5123, k_uint = 5125, k_float = 5126 };

size_t component_size(int type) { return type == k_byte || type == k_ubyte ? 1 : type == k_short || type == k_ushort ? 2 : 4; }

struct TypeName {
  std::string_view name;
  int components, columns;
};
constexpr TypeName k_types[] = {{"SCALAR", 1, 1}, {"VEC2", 2, 1}, {"VEC3", 3, 1}, {"VEC4", 4, 1},
                                {"MAT2", 4, 2},   {"MAT3", 9, 3}, {"MAT4", 16, 4}};

template <class T>
T load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

uint32_t load_unsigned(const std::byte* from, int type) {
  return type == k_ubyte ? load<uint8_t>(from) : type == k_ushort ? load<uint16_t>(from) : load<uint32_t>(from);
}

float load_component(const std::byte* from, int type, bool normalised) {
  switch (type) {
    case k_byte:
      return normalised ? std::max(load<int8_t>(from) / 127.0f, -1.0f) : load<int8_t>(from);
    case k_ubyte:
      return normalised ? load<uint8_t>(from) / 255.0f : load<uint8_t>(from);
    case k_short:
      return normalised ? std::max(load<int16_t>(from) / 32767.0f, -1.0f) : load<int16_t>(from);
    case k_ushort:
      return normalised ? load<uint16_t>(from) / 65535.0f : load<uint16_t>(from);
    case k_uint:
      return static_cast<float>(load<uint32_t>(from));
    default:
      return load<float>(from);
  }
}

}  // namespace

GltfAccessors::GltfAccessors(GltfDocument& document) : document_(document) {
  for (const GltfValue& json : document.root().objects("accessors")) accessors_.push_back(read_accessor(json));
}

float GltfAccessors::normalised_scale(int accessor) const {
  const Accessor& a = at(accessor);
  if (!a.normalised) return 1.0f;
  switch (a.component_type) {
    case k_byte:
      return 1.0f / 127.0f;
    case k_ubyte:
      return 1.0f / 255.0f;
    case k_short:
      return 1.0f / 32767.0f;
    case k_ushort:
      return 1.0f / 65535.0f;
    default:
      return 1.0f;
  }
}

bool GltfAccessors::is_unsigned(int accessor) const {
  const Accessor& a = at(accessor);
  return !a.normalised && (a.component_type == k_ubyte || a.component_type == k_ushort || a.component_type == k_uint);
}

GltfAccessors::Accessor GltfAccessors::read_accessor(const GltfValue& json) const {
  Accessor a;
  a.place = json.place();
  a.type = json.text("type", "");
  const auto type = std::find_if(std::begin(k_types), std::end(k_types), [&](const TypeName& t) { return t.name == a.type; });
  if (type == std::end(k_types)) json.fail_in("type", "is \"{}\"; valid: SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4", a.type);
  a.component_type = static_cast<int>(json.required_integer("componentType", k_byte, k_float));
  if (a.component_type == 5124) json.fail_in("componentType", "is 5124; valid: 5120, 5121, 5122, 5123, 5125, 5126");
  a.components = type->components;
  const size_t size = component_size(a.component_type);
  // Columns of matrices start at multiples of four bytes.
  const size_t column = static_cast<size_t>(type->components / type->columns) * size;
  a.element_size = type->columns == 1 ? column : static_cast<size_t>(type->columns) * ((column + 3) & ~size_t{3});
  a.normalised = json.flag("normalized", false) && a.component_type != k_float;
  a.count = json.required_integer("count", 1, 0xffffffffu);
  a.view = json.index("bufferView", document_.view_count(), "bufferViews");
  a.offset = json.integer("byteOffset", 0, 0, uint64_t{1} << 40);
  if (a.view >= 0) {
    const size_t stride = document_.view_stride(a.view);
    a.stride = stride ? stride : a.element_size;
    if (a.stride < a.element_size) {
      json.fail_in("bufferView", "bufferViews[{}].byteStride is {}; valid: at least the size of an element, {}", a.view,
                   a.stride, a.element_size);
    }
    const uint64_t length = document_.view_length(a.view), end = a.offset + a.stride * (a.count - 1) + a.element_size;
    if (end > length)
      json.fail_in("count", "{} elements end at byte {} of bufferViews[{}]; valid: at most {}", a.count, end, a.view, length);
  }
  if (const auto sparse = json.object("sparse")) a.sparse = read_sparse(*sparse, a);
  return a;
}

GltfAccessors::Sparse GltfAccessors::read_sparse(const GltfValue& json, const Accessor& accessor) const {
  Sparse sparse;
  sparse.count = json.required_integer("count", 1, accessor.count);
  const GltfValue indices = json.required_object("indices"), values = json.required_object("values");
  sparse.index_view = indices.required_index("bufferView", document_.view_count(), "bufferViews");
  sparse.index_offset = indices.integer("byteOffset", 0, 0, uint64_t{1} << 40);
  sparse.index_type = static_cast<int>(indices.required_integer("componentType", k_ubyte, k_uint));
  if (sparse.index_type != k_ubyte && sparse.index_type != k_ushort && sparse.index_type != k_uint) {
    indices.fail_in("componentType", "is {}; valid: 5121, 5123, 5125", sparse.index_type);
  }
  sparse.value_view = values.required_index("bufferView", document_.view_count(), "bufferViews");
  sparse.value_offset = values.integer("byteOffset", 0, 0, uint64_t{1} << 40);
  return sparse;
}

Bytes GltfAccessors::elements(int view, uint64_t offset, size_t stride, size_t element_size, size_t count,
                              const std::string& place) const {
  const Bytes bytes = document_.view(view, place);
  const uint64_t end = offset + stride * (count - 1) + element_size;
  if (end > bytes.size()) {
    fail("{}: {}: {} elements end at byte {} of bufferViews[{}]; it holds {}", document_.name(), place, count, end, view,
         bytes.size());
  }
  return bytes.subspan(offset);
}

void GltfAccessors::require_type(const Accessor& accessor, int components, const std::string& place) const {
  const std::string valid(components == 16 ? std::string_view("MAT4") : k_types[components - 1].name);
  if (accessor.type != valid) {
    fail("{}: {}: {}.type is {}; valid: {}", document_.name(), place, accessor.place, accessor.type, valid);
  }
}

std::vector<uint32_t> GltfAccessors::sparse_indices(const Accessor& accessor) const {
  const Sparse& sparse = *accessor.sparse;
  const std::string place = accessor.place + ".sparse.indices";
  const size_t size = component_size(sparse.index_type);
  const Bytes bytes = elements(sparse.index_view, sparse.index_offset, size, size, sparse.count, place);
  std::vector<uint32_t> indices(sparse.count);
  for (size_t i = 0; i < sparse.count; ++i) {
    indices[i] = load_unsigned(bytes.data() + i * size, sparse.index_type);
    if (indices[i] >= accessor.count)
      fail("{}: {}: element {} is {}; valid: 0 to {}", document_.name(), place, i, indices[i], accessor.count - 1);
  }
  return indices;
}

void GltfAccessors::read_floats(const Accessor& a, const std::vector<uint32_t>* only, float* out, size_t* lost) const {
  const size_t size = component_size(a.component_type), components = static_cast<size_t>(a.components);
  const auto read = [&](const std::byte* from, float* to, size_t element) {
    bool finite = true;
    for (size_t c = 0; c < components; ++c) {
      to[c] = load_component(from + c * size, a.component_type, a.normalised);
      finite = finite && std::isfinite(to[c]);
    }
    if (finite) return;
    if (!lost) fail("{}: {}: element {} is not finite; valid: finite numbers", document_.name(), a.place, element);
    std::fill(to, to + components, 0.0f);
    ++*lost;
  };
  const size_t count = only ? only->size() : a.count;
  const auto element_of = [&](size_t i) { return only ? size_t{(*only)[i]} : i; };
  if (a.view >= 0) {
    const Bytes bytes = elements(a.view, a.offset, a.stride, a.element_size, a.count, a.place);
    for (size_t i = 0; i < count; ++i) read(bytes.data() + element_of(i) * a.stride, out + i * components, element_of(i));
  } else {
    std::fill(out, out + count * components, 0.0f);
  }
  if (!a.sparse) return;
  const std::vector<uint32_t> changed = sparse_indices(a);
  const Bytes bytes = elements(a.sparse->value_view, a.sparse->value_offset, a.element_size, a.element_size, a.sparse->count,
                               a.place + ".sparse.values");
  std::vector<uint32_t> place_of;  // element -> where it goes; 0 = nowhere, else 1 + place
  if (only) {
    document_.budget().take(a.count, a.place);
    place_of.assign(a.count, 0);
    for (size_t i = 0; i < count; ++i) place_of[(*only)[i]] = static_cast<uint32_t>(i + 1);
  }
  for (size_t i = 0; i < changed.size(); ++i) {
    const size_t to = only ? place_of[changed[i]] : size_t{changed[i]} + 1;
    if (to > 0) read(bytes.data() + i * a.element_size, out + (to - 1) * components, changed[i]);
  }
}

std::vector<float> GltfAccessors::numbers(int accessor, int components, const std::string& place) const {
  const Accessor& a = at(accessor);
  require_type(a, components, place);
  document_.budget().take(a.count, place);
  std::vector<float> values(a.count * static_cast<size_t>(a.components));
  read_floats(a, nullptr, values.data(), nullptr);
  return values;
}

std::vector<uint32_t> GltfAccessors::indices(int accessor, const std::string& place) const {
  const Accessor& a = at(accessor);
  require_type(a, 1, place);
  if (a.component_type != k_ubyte && a.component_type != k_ushort && a.component_type != k_uint) {
    fail("{}: {}: {}.componentType is {}; valid: 5121, 5123, 5125", document_.name(), place, a.place, a.component_type);
  }
  document_.budget().take(a.count, place);
  std::vector<uint32_t> result(a.count, 0);
  if (a.view >= 0) {
    const Bytes bytes = elements(a.view, a.offset, a.stride, a.element_size, a.count, a.place);
    for (size_t i = 0; i < a.count; ++i) result[i] = load_unsigned(bytes.data() + i * a.stride, a.component_type);
  }
  if (a.sparse) {
    const std::vector<uint32_t> changed = sparse_indices(a);
    const Bytes bytes = elements(a.sparse->value_view, a.sparse->value_offset, a.element_size, a.element_size, a.sparse->count,
                                 a.place + ".sparse.values");
    for (size_t i = 0; i < changed.size(); ++i)
      result[changed[i]] = load_unsigned(bytes.data() + i * a.element_size, a.component_type);
  }
  return result;
}

}  // namespace gnomon
