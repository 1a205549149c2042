// SPDX-License-Identifier: GPL-3.0-or-later
#include "errors.h"

#include <mesh_tools/measure.h>
#include <mesh_tools/mesh_io.h>
#include <vcg_core/errors.h>

namespace anisosmooth_python {

namespace nb = nanobind;

void declare_errors(nb::module_& module) {
  static PyObject* cancelled = PyErr_NewException("anisosmooth.Cancelled", nullptr, nullptr);
  module.attr("Cancelled") = nb::handle(cancelled);
  nb::register_exception_translator([](const std::exception_ptr& exception, void*) {
    try {
      std::rethrow_exception(exception);
    } catch (const vcg_core::Cancelled& error) {
      PyErr_SetString(cancelled, error.what());
    } catch (const vcg_core::Error& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    } catch (const mesh_tools::FileError& error) {
      PyErr_SetString(PyExc_OSError, error.what());
    } catch (const mesh_tools::DifferentConnectivity& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
}

}  // namespace anisosmooth_python
