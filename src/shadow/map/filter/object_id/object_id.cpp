// Object-ID and priority buffers (Hourcade and Nicolas 1985, "Algorithms for antialiased cast shadows"): the map stores which
// object is nearest to the light, and a point is lit where its own is. Ids are equal or not: no bias, no acne. Cost: a colour
// attachment beside the depth map; one id and one depth for each texel read. Fails: nothing shadows itself (within=lit), and a
// texel whose centre belongs to the neighbour is dark without priority: at every outline and wherever objects touch.
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Lit where the map stores the receiver's own id.\n"
    "Hourcade and Nicolas 1985. Ids are equal or not, so an object has no acne on itself and needs no bias. What the method "
    "cannot do:\n"
    "with object_id.within=lit nothing with one id shadows itself - a room that is one object is full of light - unless it is "
    "split\n"
    "(object_id.parts=item). within=depth, the default, also compares depths where the receiver's own id is stored, with a "
    "bias so\n"
    "coarse that acne cannot return, while contacts between objects stay sharp. The original ranks objects by distance from "
    "the\n"
    "light; object_id.priority takes the stored depth for the rank. Without it texels at outlines are dark: they belong to "
    "whatever\n"
    "lies at their centre. object_id.size averages comparisons, not ids. One attachment more in the depth pass.";

class ObjectId : public Filter {
 public:
  explicit ObjectId(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  float reach() const override { return 0.5f * static_cast<float>(params_.size) + 1.0f; }
  bool object_ids() const override { return true; }
  bool item_ids() const override { return params_.parts == parts_item; }

 private:
  Params params_;
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock& params) -> std::unique_ptr<Filter> { return std::make_unique<ObjectId>(params); }};
}

}  // namespace gnomon
