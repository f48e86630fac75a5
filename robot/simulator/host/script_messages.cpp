// SPDX-License-Identifier: MIT
#include "robot/simulator/host/script_messages.h"

#include "robot/simulator/plant/plant.h"

namespace tiller::simulator {

void ScriptMessages::textMessage(std::string_view text) {
    plant_.publish(primary::text(plant_.timestampNs(), text));
}

void ScriptMessages::programLabel(int number, std::string_view text) {
    plant_.publish(primary::label(plant_.timestampNs(), number, text));
}

int ScriptMessages::showPopup(const urscript::Popup& popup) {
    const int id = plant_.popups().open(popup.blocking);
    plant_.publish(primary::popup(
        plant_.timestampNs(),
        {static_cast<std::uint32_t>(id), popup.warning, popup.error, popup.blocking, popup.title, popup.text},
        plant_.options().software));
    return id;
}

bool ScriptMessages::popupOpen(int id) const {
    return plant_.popups().isOpen(id);
}

// ---- values requested from the operator -----------------------------------------------------------------

Result<int> ScriptMessages::requestValue(urscript::RequestedType kind, std::string_view text) {
    ++lastRequest_;
    requests_[lastRequest_] = {kind, std::nullopt};
    plant_.publish(primary::requestValue(plant_.timestampNs(), static_cast<std::uint32_t>(lastRequest_),
                                         static_cast<std::uint32_t>(kind), text));
    return lastRequest_;
}

std::optional<urscript::RequestAnswer> ScriptMessages::requestedValue(int id) {
    const auto it = requests_.find(id);
    if (it == requests_.end() || !it->second.answer) {
        return std::nullopt;
    }
    auto answer = std::move(it->second.answer);
    requests_.erase(it);
    return answer;
}

std::optional<urscript::RequestedType> ScriptMessages::asked() const {
    for (const auto& [id, request] : requests_) {
        if (!request.answer) {
            return request.kind;
        }
    }
    return std::nullopt;
}

bool ScriptMessages::answerRequest(const urscript::RequestAnswer& answer) {
    // Only the oldest open request can be answered, and only with a value of its type. The variant index
    // equals the requested type.
    for (auto& [id, request] : requests_) {
        if (!request.answer) {
            if (answer.index() != static_cast<std::size_t>(request.kind)) {
                return false;
            }
            request.answer = answer;
            return true;
        }
    }
    return false;
}

}  // namespace tiller::simulator
