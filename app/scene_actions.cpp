// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_actions.h"

#include "app/action_table.h"
#include "widgets/scene/scene_view.h"

namespace tiller::app {

void SceneActions::addTo(ActionTable& table, SceneView& view) {
    struct Side {
        const char* id;
        QString text;
        QString help;
        Qt::Key key;
        StandardView from;
    };
    // Use function keys, because letters and digits are used for teaching and by the armed keyboard.
    const Side sides[] = {
        {"view.look.home", tr("Default view (perspective)"),
         tr("Shows the arm diagonally from the front, slightly from above, and fits everything in the view."),
         Qt::Key_F5, StandardView::Home},
        {"view.look.front", tr("Look from the front"), tr("Base X to the right, Z up."), Qt::Key_F6,
         StandardView::Front},
        {"view.look.side", tr("Look from the side"), tr("Base Y to the right, Z up."), Qt::Key_F7,
         StandardView::Side},
        {"view.look.top", tr("Look from above"), tr("Base X to the right, Y up."), Qt::Key_F8,
         StandardView::Top}};
    for (const Side& side : sides) {
        table.add({QLatin1String(side.id), side.text, side.help, QKeySequence(side.key),
                   [&view, from = side.from] { view.lookFrom(from); }});
    }
    table.add({"view.look.fit", tr("Fit everything in the view"),
               tr("Fit the arm, target and waypoints in the view without changing the viewing direction."),
               QKeySequence(Qt::Key_F9), [&view] { view.fitAll(); }});
}

}  // namespace tiller::app
