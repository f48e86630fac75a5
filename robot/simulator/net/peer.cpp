// SPDX-License-Identifier: MIT
#include "robot/simulator/net/peer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "robot/simulator/net/link.h"

namespace tiller::simulator {

namespace {
/// Capacity of the system's socket buffer while the cable is unplugged [bytes].
constexpr std::size_t kSystemBuffer = 256 * 1024;
/// Maximum number of delayed bytes, sufficient for the longest delay at the highest data rate.
constexpr std::size_t kMaxBuffered = 16 * 1024 * 1024;
/// Maximum number of waiting segments for splitting. Further segments are not split, because the queue could
/// never be sent in time.
constexpr std::size_t kMaxSplitWaiting = 64;
/// Delay of the second piece of a split segment [s]. Any positive value defers the piece to the next control
/// period.
constexpr double kMoment = 1e-6;
}  // namespace

Peer::Peer(native_socket::Descriptor descriptor, std::size_t backlog)
    : descriptor_(descriptor), port_(native_socket::peerPort(descriptor)), backlog_(backlog) {}

Peer::~Peer() {
    close();
}

void Peer::attach(Link* link) {
    link_ = link;
    isWatched_ = link_ != nullptr && open_ && link_->poller().add(descriptor_, &hasArrived_);
}

bool Peer::isPlain() const {
    return link_ == nullptr || link_->isPlain();
}

void Peer::close() {
    if (open_) {
        open_ = false;
        if (isWatched_) {
            link_->poller().remove(descriptor_);
        }
        if (link_ == nullptr || !link_->bury(descriptor_)) {
            native_socket::close(descriptor_);
        }
    }
}

// ---- from the client ------------------------------------------------------------------------------------

std::size_t Peer::receive(std::span<std::uint8_t> into) {
    if (!open_ || into.empty()) {
        return 0;
    }
    return isPlain() && arriving_.empty() && !ended_ && !wasLost_ ? receiveNow(into)
                                                                  : receiveThroughCable(into);
}

std::size_t Peer::receiveNow(std::span<std::uint8_t> into) {
    if (!hasArrived_) {
        return 0;
    }
    const native_socket::Transfer got = native_socket::receive(descriptor_, into);
    switch (got.status) {
        case native_socket::Status::Ok:
            // A partial read means that all data have been read.
            hasArrived_ = !isWatched_ || got.bytes == into.size();
            return got.bytes;
        case native_socket::Status::WouldBlock:
            hasArrived_ = !isWatched_;
            return 0;
        case native_socket::Status::Closed:
        case native_socket::Status::Failed:
            close();
            return 0;
    }
    return 0;
}

std::size_t Peer::receiveThroughCable(std::span<std::uint8_t> into) {
    if (link_->isLost()) {
        wasLost_ = true;
        return 0;
    }
    if (std::exchange(wasLost_, false) && !ended_) {
        receiveAfterOutage();
    }
    std::array<std::uint8_t, 16 * 1024> buffer;
    const native_socket::Transfer got = ended_ ? native_socket::Transfer{native_socket::Status::WouldBlock, 0}
                                               : native_socket::receive(descriptor_, buffer);
    if (got.status == native_socket::Status::Ok) {
        const double due = std::max(link_->arrival(), arriving_.empty() ? 0.0 : arriving_.back().due);
        arriving_.push_back({due, {buffer.begin(), buffer.begin() + static_cast<long>(got.bytes)}});
    } else if (got.status != native_socket::Status::WouldBlock) {
        ended_ = true;
    }
    if (arriving_.empty()) {
        if (ended_) {
            close();
        }
        return 0;
    }
    Segment& first = arriving_.front();
    if (first.due > link_->now()) {
        return 0;
    }
    const std::size_t count = std::min(into.size(), first.bytes.size() - first.gone);
    std::memcpy(into.data(), first.bytes.data() + first.gone, count);
    first.gone += count;
    if (first.gone == first.bytes.size()) {
        arriving_.pop_front();
    }
    return count;
}

// Data that the client sent during the outage arrive now, because the client retransmits unacknowledged data
// unless it has reset the connection.
void Peer::receiveAfterOutage() {
    std::array<std::uint8_t, 16 * 1024> buffer;
    std::vector<std::uint8_t> all;
    native_socket::Transfer got{native_socket::Status::Ok, 0};
    while (got.status == native_socket::Status::Ok && all.size() < kMaxBuffered) {
        got = native_socket::receive(descriptor_, buffer);
        all.insert(all.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(got.bytes));
    }
    ended_ = got.status == native_socket::Status::Closed || got.status == native_socket::Status::Failed;
    if (got.status != native_socket::Status::Failed && !all.empty()) {
        const double due = std::max(link_->arrival(), arriving_.empty() ? 0.0 : arriving_.back().due);
        arriving_.push_back({due, std::move(all)});
    }
}

// ---- to the client --------------------------------------------------------------------------------------

std::size_t Peer::sendNow(std::span<const std::uint8_t> bytes) {
    std::size_t done = 0;
    while (open_ && !isUnresponsive_ && done < bytes.size()) {
        const native_socket::Transfer moved = native_socket::send(descriptor_, bytes.subspan(done));
        if (moved.status == native_socket::Status::Ok) {
            done += moved.bytes;
        } else if (moved.status == native_socket::Status::WouldBlock) {
            break;
        } else {
            endSending();
        }
    }
    return done;
}

// Called after the client has closed the connection. Data sent earlier are still processed, e.g. a program
// whose sender does not wait for a reply.
void Peer::endSending() {
    isUnresponsive_ = true;
    std::array<std::uint8_t, 16 * 1024> buffer;
    std::size_t kept = 0;
    while (link_ != nullptr && !ended_ && kept < kMaxBuffered) {
        const native_socket::Transfer got = native_socket::receive(descriptor_, buffer);
        if (got.status != native_socket::Status::Ok) {
            break;
        }
        arriving_.push_back({link_->now(), {buffer.begin(), buffer.begin() + static_cast<long>(got.bytes)}});
        kept += got.bytes;
    }
    ended_ = true;
    if (arriving_.empty()) {
        close();
    }
}

void Peer::put(std::span<const std::uint8_t> bytes) {
    const std::size_t gone = pending() > 0 ? 0 : sendNow(bytes);
    if (pending() == 0) {
        out_.clear();
        sent_ = 0;
    }
    out_.insert(out_.end(), bytes.begin() + static_cast<std::ptrdiff_t>(gone), bytes.end());
}

bool Peer::send(std::span<const std::uint8_t> bytes, std::optional<double> stamp) {
    if (!open_ || closing_ || isUnresponsive_) {
        return true;  // the connection is ending, so this is not an error
    }
    flush();
    if (!isPlain() || !held_.empty()) {
        return hold(bytes, stamp);
    }
    if (pending() > 0 && pending() + bytes.size() > backlog_) {
        return false;
    }
    put(bytes);
    noteDelivered(stamp);
    return true;
}

// Called after sending. Data that the socket has not accepted are not delivered, because the client is not
// reading.
void Peer::noteDelivered(std::optional<double> stamp) {
    if (stamp && pending() == 0) {
        delivered_ = stamp;
    }
}

bool Peer::send(std::string_view text) {
    return send({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

bool Peer::hold(std::span<const std::uint8_t> bytes, std::optional<double> stamp) {
    const std::size_t most = link_->isLost() ? backlog_ + kSystemBuffer : kMaxBuffered;
    if (pending() > backlog_ || heldBytes_ + bytes.size() > most) {
        return false;
    }
    const double due = std::max(link_->departure(), held_.empty() ? 0.0 : held_.back().due);
    held_.push_back({due, {bytes.begin(), bytes.end()}, 0, stamp});
    heldBytes_ += bytes.size();
    return true;
}

void Peer::releaseHeld() {
    if (link_->isLost()) {
        return;
    }
    const std::size_t splitAt = held_.size() > kMaxSplitWaiting ? 0 : link_->conditions().splitAt;
    while (!held_.empty() && held_.front().due <= link_->now()) {
        Segment& first = held_.front();
        const std::size_t left = first.bytes.size() - first.gone;
        const bool breaks = splitAt > 0 && first.gone == 0 && left > splitAt;
        const std::size_t count = breaks ? splitAt : left;
        put(std::span(first.bytes).subspan(first.gone, count));
        first.gone += count;
        heldBytes_ -= count;
        if (breaks) {
            first.due = link_->now() + kMoment;
            return;
        }
        noteDelivered(first.stamp);
        held_.pop_front();
    }
}

void Peer::flush() {
    if (!open_) {
        return;
    }
    if (isUnresponsive_) {
        out_.clear();
        sent_ = 0;
        held_.clear();
        heldBytes_ = 0;
        if (closing_) {
            close();
        }
        return;
    }
    if (link_ != nullptr && link_->isLost()) {
        return;
    }
    if (pending() > 0) {
        sent_ += sendNow(std::span(out_).subspan(sent_));
    }
    if (pending() == 0) {
        out_.clear();
        sent_ = 0;
    }
    if (!held_.empty()) {
        releaseHeld();
    }
    if (closing_ && pending() == 0 && held_.empty()) {
        close();
    }
}

void Peer::closeAfterFlush() {
    closing_ = true;
    flush();
}

}  // namespace tiller::simulator
