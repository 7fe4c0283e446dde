// What the user asked for may not be possible: that is told, and the program goes on.
#pragma once

#include <string>

#include "gpu/device_errors.h"

namespace gnomon::viewer {

// False where it threw an Error, which is then the message. A failure of the device ends the program.
template <class Do>
bool attempt(std::string& message, const Do& action) {
  try {
    action();
    return true;
  } catch (const DeviceFailure&) {
    throw;
  } catch (const Error& error) {
    message = error.what();
    return false;
  }
}

}  // namespace gnomon::viewer
