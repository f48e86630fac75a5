// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The functions of the jog column as commands, for the command list and for use without a mouse.

#include <QCoreApplication>
#include <functional>

namespace tiller {
class JogColumn;
class KeyboardJog;
}  // namespace tiller

namespace tiller::app {

class ActionTable;

class JogActions {
    Q_DECLARE_TR_FUNCTIONS(JogActions)

public:
    /// column, keyboard  must outlive the table
    static void addTo(ActionTable& table, JogColumn& column, KeyboardJog& keyboard,
                      const std::function<void()>& showTrainer);
    /// Updates the lengths and speeds in the names after a change of units.
    static void rename(ActionTable& table);
};

}  // namespace tiller::app
