// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include <mesh_tools/mesh_io.h>

namespace mesh_tools::io {

/// A file's bytes, for a format that needs a part of them at a time: of a file of a hundred megabytes, the system
/// takes longer for the memory than for the bytes.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  virtual std::size_t size() const = 0;
  /// `count` bytes from `offset` on, which are there; valid until the next call.
  /// @throws FileError
  virtual const char* part(std::size_t offset, std::size_t count) = 0;
  /// All of them, kept from then on.
  /// @throws FileError
  virtual std::string& whole() = 0;
};

/// Bytes that somebody else keeps in memory.
class BytesInMemory : public ByteSource {
 public:
  explicit BytesInMemory(std::string& bytes) : bytes_(bytes) {}

  std::size_t size() const override { return bytes_.size(); }
  const char* part(std::size_t offset, std::size_t /*count*/) override { return bytes_.data() + offset; }
  std::string& whole() override { return bytes_; }

 private:
  std::string& bytes_;
};

/// Bytes of a file, read when they are asked for: a window of them, if not all.
class BytesOfFile : public ByteSource {
 public:
  explicit BytesOfFile(const SourceFile& file) : file_(file) {}

  std::size_t size() const override { return file_.size(); }
  const char* part(std::size_t offset, std::size_t count) override;
  std::string& whole() override;

 private:
  const SourceFile& file_;
  std::string bytes_;
  std::size_t begin_ = 0;  ///< where in the file bytes_ begin
};

}  // namespace mesh_tools::io
