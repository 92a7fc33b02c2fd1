// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <limits>

#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

/// A file of text whose numbers have all digits.
class TextFile {
 public:
  /// @throws std::invalid_argument  if it cannot be written, as does close
  explicit TextFile(const std::filesystem::path& path)
      : path_(path), stream_(path) {
    stream_.precision(std::numeric_limits<double>::max_digits10);
    require_good();
  }

  template <class Value>
  TextFile& operator<<(const Value& value) {
    stream_ << value;
    return *this;
  }

  void close() {
    stream_.close();
    require_good();
  }

 private:
  void require_good() const {
    if (!stream_) refuse("the file ", path_.string(), " cannot be written");
  }

  std::filesystem::path path_;
  std::ofstream stream_;
};

}  // namespace ffcontact::plugin
