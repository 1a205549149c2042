// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace vcg_core {

/// Base of everything that this library throws on purpose. `what()` is one sentence for the person in front of the
/// program: it names what is wrong, where, and what is allowed. Whenever a function throws, the mesh it was given is
/// bit for bit as it was before the call. (`std::bad_alloc` passes through with the same promise.)
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The mesh cannot be processed: no faces, a coordinate that is not finite, a face that refers to no vertex of it.
class InvalidMesh : public Error {
 public:
  using Error::Error;
};

/// A parameter is outside its range.
class InvalidParameter : public Error {
 public:
  using Error::Error;
};

/// The progress callable returned false.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace vcg_core
