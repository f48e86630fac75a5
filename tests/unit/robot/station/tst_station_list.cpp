// SPDX-License-Identifier: MIT
#include <QTest>
#include <memory>

#include "robot/station/station_list.h"

using namespace tiller;

namespace {

std::unique_ptr<Station> made(const QString& name) {
    return std::make_unique<Station>(name, std::make_unique<ProjectDocument>());
}

}  // namespace

class TestStationList : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void stationsAreFoundByTheirNames() {
        StationList list;
        QStringList added;
        connect(&list, &StationList::added, &list, [&](const Station& station) { added << station.name(); });
        QCOMPARE(list.count(), 0);
        QVERIFY(list.find("Lab UR5e") == nullptr);
        Station* const first = list.add(made("Lab UR5e")).value();
        Station* const second = list.add(made("Lab UR10e")).value();
        QCOMPARE(added, QStringList({"Lab UR5e", "Lab UR10e"}));
        QCOMPARE(list.count(), 2);
        QCOMPARE(&list.at(0), first);
        QCOMPARE(&list.at(1), second);
        QCOMPARE(list.find("Lab UR10e"), second);
        QVERIFY(list.find("lab ur5e") == nullptr);
        QVERIFY(&first->session() != &second->session());
    }

    void signalsAreNamedByTheirStation() {
        StationList list;
        Station* const first = list.add(made("Lab UR5e")).value();
        Station* const second = list.add(made("Lab UR5")).value();
        QCOMPARE(list.ofSignal("Lab UR5e/actual_q_0"), first);
        QCOMPARE(list.ofSignal("Lab UR5/actual_q_0"), second);
        QCOMPARE(list.ofSignal("Lab UR5/run 1.mcap/actual_q_0"), second);
        QVERIFY(list.ofSignal("actual_q_0") == nullptr);
        QVERIFY(list.ofSignal("Lab UR3/actual_q_0") == nullptr);
    }

    void aNameIdentifiesOneStation() {
        StationList list;
        QVERIFY(list.add(made("Lab UR5e")).ok());
        for (const QString& name : {QString("Lab UR5e"), QString(), QString("Lab/UR5e")}) {
            const Result<Station*> result = list.add(made(name));
            QVERIFY2(!result, qPrintable(name));
            QCOMPARE(result.error().code, ErrorCode::InvalidArgument);
            QVERIFY(result.error().controllerMessage.contains("name"));
        }
        QCOMPARE(list.count(), 1);
    }

    void aRemovedStationEnds() {
        StationList list;
        Station* const first = list.add(made("Lab UR5e")).value();
        QVERIFY(list.add(made("Lab UR10e")).ok());
        bool ended = false;
        connect(first, &QObject::destroyed, &list, [&ended] { ended = true; });
        QString removed;
        connect(&list, &StationList::removed, &list, [&](Station& station) {
            removed = station.name();
            QVERIFY(!ended);
            QVERIFY(list.find(removed) == nullptr);
        });
        QVERIFY(!list.remove("Lab UR3"));
        QVERIFY(removed.isEmpty());
        QVERIFY(list.remove("Lab UR5e"));
        QCOMPARE(removed, QString("Lab UR5e"));
        QVERIFY(ended);
        QCOMPARE(list.count(), 1);
        QCOMPARE(list.at(0).name(), QString("Lab UR10e"));
        QVERIFY(list.add(made("Lab UR5e")).ok());
    }
};

QTEST_GUILESS_MAIN(TestStationList)
#include "tst_station_list.moc"
