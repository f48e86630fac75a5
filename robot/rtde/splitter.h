// SPDX-License-Identifier: MIT
#pragma once

// Splits a byte stream into RTDE packages, for both ends of a connection, and validates every length.
// Source: RTDE guide.

#include <optional>
#include <span>

#include "robot/core/error.h"
#include "robot/rtde/protocol.h"

namespace tiller::rtde {

/// One complete package; the payload points into the buffer of the splitter.
struct PackageView {
    PackageType type{};
    ByteView payload;
};

/// Splits a byte stream into packages, regardless of how it is divided into segments.
/// Threads  one at a time. Real-time: yes (the buffer is allocated once, at construction)
class PackageSplitter {
public:
    enum class Fault {
        None,
        TooSmall,  ///< a size field below 3
        TooLarge,  ///< a size field above the limit
    };

    /// limit  the largest package accepted [bytes, header included]
    explicit PackageSplitter(std::size_t limit = kMaxPackageSize);

    /// Free space for received bytes. Never empty if there is no fault and all complete packages have been
    /// taken. Call commit() with the number of bytes received. Invalidates earlier views.
    std::span<std::uint8_t> writable();
    void commit(std::size_t bytes);  ///< Marks `bytes` of the writable space as received.

    /// Copies bytes into the buffer. Invalidates earlier views.
    /// Returns  the number of bytes accepted; fewer than offered if the buffer is full until packages are
    /// taken, or after a fault
    std::size_t feed(ByteView bytes);

    /// The next complete package, if any. Its view is valid until the next writable() or feed().
    std::optional<PackageView> next();
    /// True if next() would return a package.
    bool hasNext() const;

    /// After a fault the stream is undefined, and next() returns nothing until reset().
    Fault fault() const { return fault_; }
    /// ProtocolError with the invalid size field; code None if there is no fault.
    Error error() const;
    void reset();  ///< Clears buffer and fault for a new connection.

private:
    std::size_t nextSize() const;
    void compact();

    std::size_t limit_;
    Bytes buffer_;
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    Fault fault_ = Fault::None;
    std::size_t faultSize_ = 0;
};

}  // namespace tiller::rtde
