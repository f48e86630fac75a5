// SPDX-License-Identifier: MIT
#pragma once

// A byte stream cut into RTDE packages, for both ends of a connection. Never trusts a length. Source: RTDE
// guide.

#include <optional>
#include <span>

#include "robot/core/error.h"
#include "robot/rtde/protocol.h"

namespace tiller::rtde {

/// One complete package; the payload points into the splitter's buffer.
struct PackageView {
    PackageType type{};
    ByteView payload;
};

/// Cuts a byte stream into packages, however it was segmented.
/// Threads  one at a time. Real-time: yes (its buffer is allocated once, at construction)
class PackageSplitter {
public:
    enum class Fault {
        None,
        TooSmall,  ///< a size field below 3
        TooLarge,  ///< a size field above the limit
    };

    /// limit  the largest package accepted [bytes, header included]
    explicit PackageSplitter(std::size_t limit = kMaxPackageSize);

    /// Room to receive into, never empty while there is no fault and packages are taken; then say how much
    /// came with commit(). Invalidates views handed out before.
    std::span<std::uint8_t> writable();
    void commit(std::size_t bytes);  ///< So many were written into the space.

    /// Copies bytes in. Invalidates views handed out before.
    /// Returns  how many were taken: less than offered when packages have to be taken out first, or after a
    ///          fault
    std::size_t feed(ByteView bytes);

    /// The next complete package, if there is one. Its view lives until the next writable() or feed().
    std::optional<PackageView> next();
    /// True when next() would return a package.
    bool hasNext() const;

    /// After a fault the stream cannot be understood any more: nothing comes out until reset().
    Fault fault() const { return fault_; }
    /// ProtocolError naming the size field that was wrong; code None when there is no fault.
    Error error() const;
    void reset();  ///< For a new connection.

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
