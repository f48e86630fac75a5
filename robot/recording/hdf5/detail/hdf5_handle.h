// SPDX-License-Identifier: MIT
#pragma once

// RAII wrappers for libhdf5 identifiers, and the libhdf5 calls used by this library. Private to
// robot/recording/hdf5.

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tiller::recording::hdf5 {

/// An identifier and the function that closes it.
class Handle {
public:
    using Close = herr_t (*)(hid_t);
    Handle() = default;
    Handle(hid_t id, Close close) : id_(id), close_(close) {}
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            id_ = std::exchange(other.id_, -1);
            close_ = other.close_;
        }
        return *this;
    }
    hid_t get() const { return id_; }
    explicit operator bool() const { return id_ >= 0; }
    /// Returns  false if buffered data could not be written to the file
    bool reset() {
        const bool closed = id_ < 0 || close_(std::exchange(id_, -1)) >= 0;
        return closed;
    }

private:
    hid_t id_ = -1;
    Close close_ = nullptr;
};

/// Suppresses the library's messages on stderr.
class Quiet {
public:
    Quiet() {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

/// Type of UTF-8 texts of this fixed length, which h5py, MATLAB and Octave can read.
Handle textType(std::size_t length);
bool putText(hid_t object, const char* name, const std::string& text);  ///< Writes a UTF-8 attribute.
bool putNumber(hid_t object, const char* name, double number);
bool putCount(hid_t object, const char* name, std::uint64_t count);
std::optional<std::string> takeText(hid_t object, const char* name);
std::optional<double> takeNumber(hid_t object, const char* name);
std::optional<std::int64_t> takeCount(hid_t object, const char* name);
std::vector<std::string> attributeNames(hid_t object);

}  // namespace tiller::recording::hdf5
