// SPDX-License-Identifier: MIT
#include "robot/rtde/splitter.h"

#include <algorithm>
#include <cstring>

#include "robot/rtde/big_endian.h"

namespace tiller::rtde {

// The buffer holds twice the largest package, so that the rest of a package fits after compacting.
PackageSplitter::PackageSplitter(std::size_t limit)
    : limit_(std::clamp(limit, kHeaderSize, kMaxPackageSize)), buffer_(2 * limit_) {}

std::span<std::uint8_t> PackageSplitter::writable() {
    if (fault_ != Fault::None) {
        return {};
    }
    compact();
    return std::span(buffer_).subspan(end_);
}

void PackageSplitter::commit(std::size_t bytes) {
    end_ = std::min(end_ + bytes, buffer_.size());
}

std::size_t PackageSplitter::feed(ByteView bytes) {
    const auto room = writable();
    const std::size_t count = std::min(room.size(), bytes.size());
    if (count > 0) {
        std::memcpy(room.data(), bytes.data(), count);
        commit(count);
    }
    return count;
}

std::size_t PackageSplitter::nextSize() const {
    return end_ - begin_ < 2 ? 0 : big_endian::read16(&buffer_[begin_]);
}

bool PackageSplitter::hasNext() const {
    const std::size_t size = nextSize();
    return fault_ == Fault::None && size >= kHeaderSize && size <= limit_ && size <= end_ - begin_;
}

std::optional<PackageView> PackageSplitter::next() {
    if (fault_ != Fault::None || end_ - begin_ < 2) {
        return std::nullopt;
    }
    const std::size_t size = nextSize();
    if (size < kHeaderSize || size > limit_) {
        fault_ = size < kHeaderSize ? Fault::TooSmall : Fault::TooLarge;
        faultSize_ = size;
        return std::nullopt;
    }
    if (size > end_ - begin_) {
        return std::nullopt;
    }
    const ByteView package = ByteView(buffer_).subspan(begin_, size);
    begin_ += size;
    return PackageView{static_cast<PackageType>(package[2]), package.subspan(kHeaderSize)};
}

Error PackageSplitter::error() const {
    switch (fault_) {
        case Fault::None:
            break;
        case Fault::TooSmall:
            return {ErrorCode::ProtocolError,
                    QStringLiteral("RTDE packet with a size field of %1, below the header's %2 bytes")
                        .arg(faultSize_)
                        .arg(kHeaderSize),
                    {}};
        case Fault::TooLarge:
            return {ErrorCode::ProtocolError,
                    QStringLiteral("RTDE packet with a size field of %1, above the limit of %2 bytes")
                        .arg(faultSize_)
                        .arg(limit_),
                    {}};
    }
    return {};
}

void PackageSplitter::reset() {
    begin_ = end_ = 0;
    fault_ = Fault::None;
    faultSize_ = 0;
}

void PackageSplitter::compact() {
    if (begin_ == 0) {
        return;
    }
    // Move the remaining bytes only if a complete package might not fit in the free space at the end.
    const std::size_t left = end_ - begin_;
    if (left == 0) {
        begin_ = end_ = 0;
    } else if (buffer_.size() - end_ < limit_) {
        std::memmove(buffer_.data(), &buffer_[begin_], left);
        begin_ = 0;
        end_ = left;
    }
}

}  // namespace tiller::rtde
