// SPDX-License-Identifier: MIT
#pragma once

// Popups shown on the teach pendant.

#include <algorithm>
#include <vector>

namespace tiller::simulator {

class Popups {
public:
    /// Returns  an ID, counted from 1
    int open(bool blocking) {
        shown_.push_back({++last_, blocking});
        return last_;
    }
    bool isOpen(int id) const {
        return std::any_of(shown_.begin(), shown_.end(), [id](const Shown& p) { return p.id == id; });
    }
    void close(int id) {
        std::erase_if(shown_, [id](const Shown& p) { return p.id == id; });
    }
    /// Closes the newest popup, as its button does. Returns false if no popup is open.
    bool closeNewest() {
        if (shown_.empty()) {
            return false;
        }
        shown_.pop_back();
        return true;
    }
    bool any() const { return !shown_.empty(); }
    bool anyBlocking() const {
        return std::any_of(shown_.begin(), shown_.end(), [](const Shown& p) { return p.blocking; });
    }
    /// At the end of a program, closes the popups for which the program waited.
    void closeBlocking() {
        std::erase_if(shown_, [](const Shown& p) { return p.blocking; });
    }

private:
    struct Shown {
        int id;
        bool blocking;
    };
    std::vector<Shown> shown_;
    int last_ = 0;
};

}  // namespace tiller::simulator
