// SPDX-License-Identifier: MIT
#include "robot/recording/mcap/detail/extra_samples.h"

#include <string>

namespace tiller::recording {

namespace {

/// Maximum difference between the arrival times of two packets of one control period [ns]. The time stamps of
/// a controller repeat after a restart.
constexpr std::int64_t kMaxApartNs = 1'000'000'000;

double stampOf(const receive::Sample& sample) {
    const auto index = sample.layout->indexOfComponent("timestamp");
    return index ? sample.at(*index) : receive::kAbsent;
}

/// Returns the fields of `first`, followed by the fields that only `second` contains.
RowJoiner::Layout united(const receive::SampleLayout& first, const receive::SampleLayout& second) {
    std::vector<std::string> names;
    for (const receive::SampleLayout* layout : {&first, &second}) {
        for (const receive::SampleLayout::Entry& entry : layout->entries()) {
            names.push_back(entry.name);
        }
    }
    return std::make_shared<const receive::SampleLayout>(names);  // ignores duplicates
}

}  // namespace

void ExtraSamples::follow(receive::Subscription subscription) {
    drain();
    subscription_ = std::move(subscription);
}

void ExtraSamples::drain() {
    while (subscription_.isValid() && subscription_.next(received_)) {
        samples_.push_back(received_);
        if (samples_.size() > capacity_) {
            samples_.pop_front();
        }
    }
}

void ExtraSamples::forgetBefore(std::int64_t hostTimeNs) {
    while (!samples_.empty() && samples_.front().hostTimeNs < hostTimeNs) {
        samples_.pop_front();
    }
}

RowJoiner::Layout RowJoiner::layout() const {
    Layout all = main_;
    const receive::SampleLayout* added = nullptr;
    for (const receive::Sample& sample : extra_) {
        if (sample.layout.get() != added) {
            added = sample.layout.get();
            all = united(*all, *added);
        }
    }
    return all;
}

const RowJoiner::Joint& RowJoiner::jointOf(const Layout& extra) {
    const auto [found, isNew] = joints_.try_emplace(extra);
    Joint& joint = found->second;
    if (isNew) {
        joint.layout = united(*main_, *extra);
        for (std::size_t i = main_->size(); i < joint.layout->size(); ++i) {
            joint.sources.push_back(*extra->indexOfComponent(joint.layout->componentNames()[i]));
        }
    }
    return joint;
}

const receive::Sample& RowJoiner::join(const receive::Sample& row) {
    while (next_ < extra_.size() && extra_[next_].hostTimeNs + kMaxApartNs < row.hostTimeNs) {
        ++next_;
    }
    const double stamp = stampOf(row);
    std::size_t at = next_;
    while (at < extra_.size() && extra_[at].hostTimeNs <= row.hostTimeNs + kMaxApartNs &&
           stampOf(extra_[at]) != stamp) {
        ++at;
    }
    if (at == extra_.size() || stampOf(extra_[at]) != stamp) {
        return row;
    }
    next_ = at + 1;
    const Joint& joint = jointOf(extra_[at].layout);
    joined_.sequence = row.sequence;
    joined_.hostTimeNs = row.hostTimeNs;
    joined_.connection = row.connection;
    joined_.lostBefore = row.lostBefore;
    joined_.layout = joint.layout;
    joined_.values.assign(row.values.begin(), row.values.end());
    for (const std::size_t source : joint.sources) {
        joined_.values.push_back(extra_[at].at(source));
    }
    return joined_;
}

}  // namespace tiller::recording
