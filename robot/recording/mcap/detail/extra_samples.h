// SPDX-License-Identifier: MIT
#pragma once

// Samples of additional fields, which arrive over other connections to the same robot, and their rows in the
// data of the main connection.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "robot/receive/receiver.h"

namespace tiller::recording {

/// The samples of the last minute.
/// Threads  one
class ExtraSamples {
public:
    explicit ExtraSamples(std::size_t capacity) : capacity_(capacity) {}

    /// Keeps the samples of this subscription from now on, in addition to the samples received before.
    void follow(receive::Subscription subscription);
    /// Keeps the samples that have arrived.
    void drain();
    void forgetBefore(std::int64_t hostTimeNs);
    const std::deque<receive::Sample>& samples() const { return samples_; }

private:
    const std::size_t capacity_;
    receive::Subscription subscription_;
    receive::Sample received_;
    std::deque<receive::Sample> samples_;
};

/// Adds the additional fields to the rows of the main connection.
/// Threads  one
class RowJoiner {
public:
    using Layout = std::shared_ptr<const receive::SampleLayout>;
    /// extra  in the order of their arrival; must outlive the object
    RowJoiner(Layout main, const std::deque<receive::Sample>& extra)
        : main_(std::move(main)), extra_(extra) {}

    /// The fields of the main connection, followed by those of all additional samples.
    Layout layout() const;
    /// Adds the fields that the robot sent in the same control period. Call in the order of the rows.
    /// Returns  `row` itself if there are none
    const receive::Sample& join(const receive::Sample& row);

private:
    /// Layout of the rows with the fields of one connection.
    struct Joint {
        Layout layout;
        std::vector<std::size_t> sources;  ///< index of each additional value in the sample
    };
    const Joint& jointOf(const Layout& extra);

    const Layout main_;
    const std::deque<receive::Sample>& extra_;
    std::size_t next_ = 0;  ///< the first sample that can belong to the next row
    std::map<Layout, Joint> joints_;
    receive::Sample joined_;
};

}  // namespace tiller::recording
