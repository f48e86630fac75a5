// SPDX-License-Identifier: MIT
#pragma once

// Numbers and texts as ROS 2 messages have them: CDR, little endian. By Fast CDR 1, as in Debian 12, or 2, as in
// Debian 13, which calls some things by other names.

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
    /// What was written [bytes], with the four that say how.
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
    /// What was written [bytes], with the four that say how.
    std::size_t size() const {
        return getSerializedDataLength();
    }
#endif
};

}  // namespace tiller::recording::mcap
