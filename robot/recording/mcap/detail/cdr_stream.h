// SPDX-License-Identifier: MIT
#pragma once

// Encodes numbers and strings as in ROS 2 messages: little-endian CDR. Supports Fast CDR 1 (Debian 12) and
// Fast CDR 2 (Debian 13), whose names differ.

#include <fastcdr/Cdr.h>

#include <cstddef>

namespace tiller::recording::mcap {

class CdrStream : public eprosima::fastcdr::Cdr {
public:
#if FASTCDR_VERSION_MAJOR >= 2
    explicit CdrStream(eprosima::fastcdr::FastBuffer& buffer)
        : Cdr(buffer, LITTLE_ENDIANNESS, eprosima::fastcdr::CdrVersion::DDS_CDR) {}
    void put(const double* numbers, std::size_t count) {
        serialize_array(numbers, count);
    }
    void take(double* numbers, std::size_t count) {
        deserialize_array(numbers, count);
    }
    /// Number of bytes written, including the four-byte encapsulation header.
    std::size_t size() const {
        return get_serialized_data_length();
    }
#else
    explicit CdrStream(eprosima::fastcdr::FastBuffer& buffer) : Cdr(buffer, LITTLE_ENDIANNESS, DDS_CDR) {}
    void put(const double* numbers, std::size_t count) {
        serializeArray(numbers, count);
    }
    void take(double* numbers, std::size_t count) {
        deserializeArray(numbers, count);
    }
    /// Number of bytes written, including the four-byte encapsulation header.
    std::size_t size() const {
        return getSerializedDataLength();
    }
#endif
};

}  // namespace tiller::recording::mcap
