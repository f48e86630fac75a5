// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "robot/station/link/gripper_choice.h"

using namespace tiller;
using Kind = GripperChoice::Kind;
using Model = GripperChoice::Model;

class TestGripperChoice : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void choicesRoundTrip() {
        for (const Model model : {Model::TwoF85, Model::TwoF140, Model::HandE}) {
            GripperChoice choice;
            choice.kind = Kind::Robotiq;
            choice.model = model;
            QVERIFY2(GripperChoice::fromText(choice.toText()) == choice, qPrintable(choice.toText()));
        }
        GripperChoice choice;
        choice.kind = Kind::TwoOutputs;
        choice.closeOutput = 3;
        choice.openOutput = 17;
        QCOMPARE(choice.toText(), QString("outputs|3|17"));
        QVERIFY(GripperChoice::fromText(choice.toText()) == choice);
        choice = {};
        choice.kind = Kind::OneOutput;
        choice.closeOutput = 8;
        QVERIFY(GripperChoice::fromText(choice.toText()) == choice);
        QVERIFY(GripperChoice().toText().isEmpty());
    }

    void invalidTextIsNoGripper_data() {
        QTest::addColumn<QString>("text");
        for (const char* text : {"", "robotiq", "robotiq|3F", "output", "output|18", "output|-1", "outputs|1",
                                 "outputs|4|4", "outputs|4|x", "nonsense|1|2", "|||"}) {
            QTest::newRow(text) << QString(text);
        }
    }
    void invalidTextIsNoGripper() {
        QFETCH(QString, text);
        QVERIFY(GripperChoice::fromText(text) == GripperChoice());
    }
};

QTEST_GUILESS_MAIN(TestGripperChoice)
#include "tst_gripper_choice.moc"
