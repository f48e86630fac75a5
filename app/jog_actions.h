// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the jog column can do, as commands: for those who have no mouse, and for the palette.

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
    /// Names speeds and steps again, after the operator chose other units.
    static void rename(ActionTable& table);
};

}  // namespace tiller::app
