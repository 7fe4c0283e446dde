// Errors after which nothing that the device does can be trusted: whoever goes on after other errors must let these pass.
#pragma once

#include "base/error.h"

namespace gnomon {

class DeviceFailure : public Error {
 public:
  using Error::Error;
};

// What validation said: a bug of gnomon.
class ValidationError : public DeviceFailure {
 public:
  using DeviceFailure::DeviceFailure;
};

// Hung, reset or removed.
class DeviceLost : public DeviceFailure {
 public:
  using DeviceFailure::DeviceFailure;
};

}  // namespace gnomon
