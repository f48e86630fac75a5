// SPDX-License-Identifier: MIT
#pragma once

// Messages of a program to the operator, and requests for input.

#include <map>
#include <optional>

#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

class Plant;

/// Threads  the simulator thread
class ScriptMessages : public virtual urscript::MessageHost {
public:
    explicit ScriptMessages(Plant& plant) : plant_(plant) {}

    /// Answers the oldest input request of a program. Returns false if there is no request or if the type
    /// does not match.
    bool answerRequest(const urscript::RequestAnswer& answer);
    /// Type of value that the oldest request expects; empty if there is no request.
    std::optional<urscript::RequestedType> asked() const;
    void forgetRequests() { requests_.clear(); }

    void textMessage(std::string_view text) override;
    void programLabel(int number, std::string_view text) override;
    int showPopup(const urscript::Popup& popup) override;
    bool popupOpen(int id) const override;
    Result<int> requestValue(urscript::RequestedType kind, std::string_view text) override;
    std::optional<urscript::RequestAnswer> requestedValue(int id) override;

private:
    struct Question {
        urscript::RequestedType kind;
        std::optional<urscript::RequestAnswer> answer;
    };

    std::map<int, Question> requests_;  ///< requests by ID
    int lastRequest_ = 0;
    Plant& plant_;
};

}  // namespace tiller::simulator
