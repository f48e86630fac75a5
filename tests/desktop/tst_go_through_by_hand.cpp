// SPDX-License-Identifier: GPL-3.0-or-later
//
// "Run route" held with a real mouse button. Everything except a steady hold ends the motion, and only a new
// press continues it.

#include "tests/desktop/interrupted_hold.h"

namespace tiller::test {

class TestGoThroughByHand : public InterruptedHold {
    Q_OBJECT

    // On a smaller screen the button is hidden, because the list and the details need the space.
    QSize screen() const override { return {1600, 1000}; }
    void hold() override {
        teach();
        const Place key = cell().place("waypoint.goThrough");
        area_ = key.area;
        holdBy([&] { hand().moveTo(area_.center()), hand().button(1, true); }, [&] { letGo(); });
    }
    void letGo() override { hand().button(1, false); }
    void comeBack() override { hand().moveTo(area_.center() + QPoint(3, 3)); }

    /// Teaches two distant waypoints if there are none, and enables the loop, so that a motion is always
    /// possible.
    void teach() {
        QVERIFY(beReady());
        if (cell().place("waypoint.empty").visible) {
            hand().tap(kLetterT);
            QVERIFY(cell().until([&] { return cell().place("waypoint.goThrough").enabled; }));
            const Vector6 from = arm().joints();
            holdBy([&] { hand().moveTo(cell().place("jog.Z+").middle()), hand().button(1, true); },
                   [&] { hand().button(1, false); });
            QVERIFY(cell().until(
                [&] { return (arm().joints() - from).cwiseAbs().maxCoeff() > 0.2 || !arm().moves(); }));
            hand().button(1, false);
            QVERIFY(arm().untilStanding(5));
            hand().tap(kLetterT);
            QVERIFY(cell().click("waypoint.routeLoop"));
            // Select all waypoints as the route. A key pressed before the list is open would be lost.
            for (int attempt = 0; attempt < 10 && !all(); ++attempt) {
                QVERIFY(cell().click("waypoint.routeScope"));
                hand().tap(kDown);
                hand().tap(kDown);
                hand().tap(kReturn);
                cell().until([&] { return all(); }, 2000);
            }
            QVERIFY2(all(), "not all waypoints could be selected");
        }
        QVERIFY(cell().until([&] { return cell().place("waypoint.goThrough").enabled; }));
    }

    bool all() { return cell().place("waypoint.routeScope").text == "All"; }

private Q_SLOTS:
    void theButtonIsReleased() {
        hold();
        hand().button(1, false);
        verifyStands();
    }

    void anotherWindowTakesTheFocus() {
        hold();
        openAnotherWindow({40, 40});
        verifyEndedForGood();
    }

    void escIsPressed() {
        hold();
        hand().tap(kEscape);
        verifyEndedForGood();
    }

    void thePointerLeavesTheKey() {
        hold();
        hand().moveTo({area_.center().x(), area_.bottom() + 60});
        verifyEndedForGood();
    }

private:
    QRect area_;
};

}  // namespace tiller::test

TILLER_DESKTOP_MAIN(tiller::test::TestGoThroughByHand)
#include "tst_go_through_by_hand.moc"
