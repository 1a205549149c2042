// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <support/flat_mesh.h>

namespace test_support {

/// A noisy model and what it was before the noise; same vertices and faces in the same order.
struct ModelPair {
  FlatMesh noisy;
  FlatMesh original;
};

/// Names of the models that tests know of.
std::vector<std::string> model_names();

/// Reads a pair from the folder that the environment variable ANISO_TEST_DATA names, or else CMake's variable of that
/// name. Nothing if it is not there: the caller then skips its test.
std::optional<ModelPair> load_model(const std::string& name);

}  // namespace test_support
