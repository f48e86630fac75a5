// SPDX-License-Identifier: MIT
#include "robot/simulator/net/link.h"

#include <cmath>

namespace tiller::simulator {

void Link::set(const LinkConditions& conditions) {
    const bool back = conditions_.lost && !conditions.lost;
    conditions_ = conditions;
    plain_ = !conditions.lost && conditions.delay <= 0 && conditions.jitter <= 0 && conditions.splitAt == 0 &&
             conditions.coalesce <= 0;
    if (back) {
        unbury();
    }
}

bool Link::drops() {
    return conditions_.drop > 0 && std::bernoulli_distribution(conditions_.drop)(random_);
}

double Link::arrival() {
    double time = now_ + conditions_.delay;
    if (conditions_.jitter > 0) {
        time += std::uniform_real_distribution<double>(0, conditions_.jitter)(random_);
    }
    return time;
}

double Link::departure() {
    const double time = arrival();
    return conditions_.coalesce > 0 ? (std::floor(time / conditions_.coalesce) + 1) * conditions_.coalesce
                                    : time;
}

bool Link::bury(native_socket::Descriptor descriptor) {
    if (!conditions_.lost && !forgetting_) {
        return false;
    }
    buried_.push_back(descriptor);
    return true;
}

void Link::unbury() {
    for (const native_socket::Descriptor descriptor : buried_) {
        native_socket::close(descriptor);
    }
    buried_.clear();
}

}  // namespace tiller::simulator
