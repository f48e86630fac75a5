// SPDX-License-Identifier: MIT
#include "robot/recording/hdf5/detail/hdf5_handle.h"

#include <algorithm>
#include <cstring>

namespace tiller::recording::hdf5 {

namespace {

// This limit exceeds the length of all texts in recordings.
constexpr std::size_t kMaxTextLength = 1u << 20;

bool put(hid_t object, const char* name, hid_t type, const void* value) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    return attribute && H5Awrite(attribute.get(), type, value) >= 0;
}

/// Reads an attribute with one number.
bool take(hid_t object, const char* name, hid_t type, void* value) {
    if (H5Aexists(object, name) <= 0) {
        return false;
    }
    const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    const Handle space(attribute ? H5Aget_space(attribute.get()) : -1, H5Sclose);
    return space && H5Sget_simple_extent_npoints(space.get()) == 1 &&
           H5Aread(attribute.get(), type, value) >= 0;
}

}  // namespace

Handle textType(std::size_t length) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), std::max<std::size_t>(length, 1));
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
    return type;
}

bool putText(hid_t object, const char* name, const std::string& text) {
    const Handle type = textType(text.size());
    const std::string bytes = text.empty() ? std::string(1, '\0') : text;
    return put(object, name, type.get(), bytes.data());
}

bool putNumber(hid_t object, const char* name, double number) {
    return put(object, name, H5T_NATIVE_DOUBLE, &number);
}

bool putCount(hid_t object, const char* name, std::uint64_t count) {
    return put(object, name, H5T_NATIVE_UINT64, &count);
}

std::optional<std::string> takeText(hid_t object, const char* name) {
    if (H5Aexists(object, name) <= 0) {
        return std::nullopt;
    }
    const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    const Handle type(attribute ? H5Aget_type(attribute.get()) : -1, H5Tclose);
    const Handle space(attribute ? H5Aget_space(attribute.get()) : -1, H5Sclose);
    if (!type || !space || H5Tget_class(type.get()) != H5T_STRING ||
        H5Sget_simple_extent_npoints(space.get()) != 1) {
        return std::nullopt;
    }
    if (H5Tis_variable_str(type.get()) > 0) {  // a text of h5py
        char* read = nullptr;
        if (H5Aread(attribute.get(), type.get(), &read) < 0 || read == nullptr) {
            return std::nullopt;
        }
        std::string text(read, strnlen(read, kMaxTextLength));
        H5free_memory(read);
        return text;
    }
    const std::size_t size = H5Tget_size(type.get());
    if (size > kMaxTextLength) {
        return std::nullopt;
    }
    std::string text(size, '\0');
    if (H5Aread(attribute.get(), type.get(), text.data()) < 0) {
        return std::nullopt;
    }
    text.resize(std::min(text.find('\0'), text.size()));
    return text;
}

std::optional<double> takeNumber(hid_t object, const char* name) {
    double number = 0;
    return take(object, name, H5T_NATIVE_DOUBLE, &number) ? std::optional(number) : std::nullopt;
}

std::optional<std::int64_t> takeCount(hid_t object, const char* name) {
    std::int64_t count = 0;
    return take(object, name, H5T_NATIVE_INT64, &count) ? std::optional(count) : std::nullopt;
}

std::vector<std::string> attributeNames(hid_t object) {
    constexpr std::size_t kMaxNames = 1000;
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5A_info_t*, void* to) -> herr_t {
        auto& list = *static_cast<std::vector<std::string>*>(to);
        list.emplace_back(name);
        return list.size() < kMaxNames ? 0 : 1;
    };
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
    return names;
}

}  // namespace tiller::recording::hdf5
