// SPDX-License-Identifier: MIT
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <limits>

#ifdef __linux__
#include <sys/resource.h>

#include <csignal>
#endif

#include "robot/project/project_file.h"

using namespace tiller;
using namespace tiller::project;

namespace {

Project sample(int waypoints = 3) {
    Project document;
    document.robot = RobotModelId::UR5e;
    const QUuid tray = QUuid::createUuid();
    document.frames.append({tray, QStringLiteral("Tray Ä"), Pose(0.5, 0.1, 0, 0, 0, 1.0 / 3), {}});
    for (int i = 0; i < waypoints; ++i) {
        Waypoint point;
        point.id = QUuid::createUuid();
        point.name = QStringLiteral("point \"%1\" } ] \\").arg(i);
        point.move = i % 2 == 0 ? MoveKind::Linear : MoveKind::Joint;
        point.priority = i % 2 == 0 ? TargetKind::Pose : TargetKind::Joints;
        point.frame = i % 2 == 0 ? tray : QUuid();
        point.tcpOffset = Pose(0, 0, 0.1234567890123456789, 0, 0, 0);
        point.joints = JointPositions(0.1, -1.1, 1.0 / 3, -1.7, 1.5, 0.3 + 0.001 * i);
        point.pose = Pose(0.1, 0.2, 0.3, 1e-17, -2.2, 0.7);
        point.jointSpeed = 0.7;
        point.toolSpeed = 0.05;
        point.blend = 0.005;
        document.waypoints.append(point);
    }
    return document;
}

QByteArray bytesOf(const Project& document) {
    const Result<QByteArray> bytes = serializeProject(document);
    return bytes ? *bytes : QByteArray();
}

/// The sample with one field of its second waypoint replaced; an undefined value removes the field.
QByteArray withField(const QString& key, const QJsonValue& value) {
    QJsonObject root = QJsonDocument::fromJson(bytesOf(sample())).object();
    QJsonArray points = root["waypoints"].toArray();
    QJsonObject point = points[1].toObject();
    if (value.isUndefined()) {
        point.remove(key);
    } else {
        point[key] = value;
    }
    points[1] = point;
    root["waypoints"] = points;
    return QJsonDocument(root).toJson();
}

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

}  // namespace

class TestProjectFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        directory_ = std::make_unique<QTemporaryDir>();
        QVERIFY(directory_->isValid());
        path_ = directory_->filePath("cell-7.tiller");
    }

    void savedValuesRoundTripExactly() {
        const Project document = sample();
        const Result<SaveReport> saved = saveProject(path_, document);
        QVERIFY2(saved.ok(), qPrintable(saved.error().toString()));
        QVERIFY(saved->keptCopy.isEmpty());
        const Result<Project> loaded = loadProject(path_);
        QVERIFY2(loaded.ok(), qPrintable(loaded.error().toString()));
        QVERIFY(*loaded == document);
    }

    void emptyProjectRoundTrips() {
        QVERIFY(saveProject(path_, {}).ok());
        const auto loaded = loadProject(path_);
        QVERIFY(loaded.ok());
        QVERIFY(loaded->waypoints.isEmpty());
        QVERIFY(!loaded->robot.has_value());
    }

    void fileStatesItsFormat() {
        const QJsonObject root = QJsonDocument::fromJson(bytesOf(sample())).object();
        QCOMPARE(root["format"].toString(), QString("tiller-project"));
        QCOMPARE(root["version"].toInt(), 2);
        QCOMPARE(root["robot"].toString(), QString("UR5e"));
    }

    void filesOfEarlierVersionsAreReadWhetherIntactOrDamaged() {
        const QByteArray now = bytesOf(sample());
        QByteArray before = now;
        before.replace("\"tiller-project\"", "\"tiller-session\"");
        QVERIFY(before != now);
        const auto read = parseProject(before);
        QVERIFY2(read.ok(), qPrintable(read.error().toString()));
        QVERIFY(*read == *parseProject(now));
        QCOMPARE(bytesOf(*read), now);
        const auto salvaged = recoverFromBytes(before.left(before.lastIndexOf("\"joints\"")));
        QVERIFY(salvaged.ok());
        QCOMPARE(salvaged->lostWaypoints, 1);
        QVERIFY(!salvaged->document.waypoints.isEmpty());
    }

    void unknownFieldsSurviveASave() {
        QJsonObject root = QJsonDocument::fromJson(bytesOf(sample(1))).object();
        root["program"] = QJsonObject{{"steps", QJsonArray{1, 2, 3}}};
        QJsonArray points = root["waypoints"].toArray();
        QJsonObject point = points[0].toObject();
        point["note"] = "mind the clamp";
        points[0] = point;
        root["waypoints"] = points;
        put(path_, QJsonDocument(root).toJson());

        Result<Project> loaded = loadProject(path_);
        QVERIFY2(loaded.ok(), qPrintable(loaded.error().toString()));
        QVERIFY(saveProject(path_, *loaded).ok());
        QCOMPARE(QJsonDocument::fromJson(contentOf(path_)).object(), root);
    }

    void missingFileIsReported() {
        const auto loaded = loadProject(directory_->filePath("none.tiller"));
        QVERIFY(loaded.error().code == ErrorCode::FileNotReadable);
        QVERIFY(loaded.error().context.contains("none.tiller"));
        QVERIFY(loadProject(directory_->path()).error().code == ErrorCode::FileNotReadable);
    }

    void newerFormatIsReported() {
        QJsonObject root = QJsonDocument::fromJson(bytesOf(sample())).object();
        root["version"] = 7;
        put(path_, QJsonDocument(root).toJson());
        const auto loaded = loadProject(path_);
        QVERIFY(loaded.error().code == ErrorCode::VersionUnsupported);
        QVERIFY(loaded.error().context.contains("version 7"));
        QVERIFY(recoverProject(path_).error().code == ErrorCode::VersionUnsupported);
    }

    void wrongFieldsAreNamed_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("where");
        const auto six = [](double last) { return QJsonArray{0, 0, 0, 0, 0, last}; };
        QTest::newRow("name missing")
            << withField("name", QJsonValue::Undefined) << "waypoints[1].name: is missing";
        QTest::newRow("name empty") << withField("name", "") << "waypoints[1].name: is empty";
        QTest::newRow("name a number")
            << withField("name", 3) << "waypoints[1].name: is a number, not a text";
        QTest::newRow("no id") << withField("id", "42") << "waypoints[1].id: \"42\" is not an id";
        QTest::newRow("move") << withField("move", "C") << "waypoints[1].move: \"C\" is neither";
        QTest::newRow("rules") << withField("rules", true) << "waypoints[1].rules: is true or false";
        QTest::newRow("five joints") << withField("joints", QJsonArray{1, 2, 3, 4, 5})
                                     << "waypoints[1].joints: has 5 numbers, not 6";
        QTest::newRow("joints text") << withField("joints", "home") << "waypoints[1].joints: is a text";
        QTest::newRow("joint null") << withField("joints", QJsonArray{0, 0, QJsonValue(), 0, 0, 0})
                                    << "waypoints[1].joints[2]: is null, not a number";
        QTest::newRow("degrees") << withField("joints", six(88.24)) << "waypoints[1].joints[5]: is 88.24 rad";
        QTest::newRow("millimetres") << withField("pose", QJsonArray{143.5, 0, 0, 0, 0, 0})
                                     << "waypoints[1].pose[0]: is 143.5 m";
        QTest::newRow("speed") << withField("toolSpeed", -1) << "waypoints[1].toolSpeed: is -1 m/s";
        QTest::newRow("blend") << withField("blend", QJsonValue::Undefined)
                               << "waypoints[1].blend: is missing";
        QTest::newRow("frame") << withField("frame", QUuid::createUuid().toString())
                               << "waypoints[1].frame: no frame";
        QTest::newRow("frame missing")
            << withField("frame", QJsonValue::Undefined) << "waypoints[1].frame: is missing";
        const auto change = [](const char* key, const QJsonValue& value) {
            QJsonObject root = QJsonDocument::fromJson(bytesOf(sample())).object();
            root[QLatin1String(key)] = value;
            return QJsonDocument(root).toJson();
        };
        QTest::newRow("format") << change("format", "other") << "not a Tiller project";
        QTest::newRow("version text") << change("version", "one") << "version: is not a whole number";
        QTest::newRow("waypoints object")
            << change("waypoints", QJsonObject()) << "waypoints: is an object, not a list";
        QTest::newRow("entry") << change("waypoints", QJsonArray{1})
                               << "waypoints[0]: is a number, not an object";
        QTest::newRow("frames text") << change("frames", "x") << "frames: is a text, not a list";
        QTest::newRow("robot") << change("robot", "UR99") << "robot: \"UR99\"";
        QTest::newRow("list") << QByteArray("[1, 2]") << "not a Tiller project";
        QTest::newRow("empty") << QByteArray() << "line 1, column 1";
        QTest::newRow("not json") << QByteArray("{\n \"a\": nonsense\n}") << "line 2";
        QTest::newRow("huge number") << bytesOf(sample()).replace("0.005", "1e999") << "illegal number";
        QTest::newRow("binary") << QByteArray(1000, '\xff') << "line 1";
        QTest::newRow("deep") << QByteArray(100000, '[') << "line 1";
    }
    void wrongFieldsAreNamed() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, where);
        put(path_, bytes);
        const auto loaded = loadProject(path_);
        QVERIFY(!loaded.ok());
        QVERIFY2(loaded.error().code == ErrorCode::FileCorrupt, qPrintable(loaded.error().toString()));
        QVERIFY2(loaded.error().context.contains("cell-7.tiller"), qPrintable(loaded.error().context));
        QVERIFY2(loaded.error().context.contains(where), qPrintable(loaded.error().context));
        QCOMPARE(contentOf(path_), bytes);
    }

    void duplicateWaypointIdsAreReported() {
        QJsonObject root = QJsonDocument::fromJson(bytesOf(sample())).object();
        QJsonArray points = root["waypoints"].toArray();
        points.append(points[0]);
        root["waypoints"] = points;
        const auto parsed = parseProject(QJsonDocument(root).toJson());
        QVERIFY(parsed.error().context.contains("waypoints[3].id"));
    }

    void recoveryKeepsAllIntactContent() {
        const QByteArray bytes = withField("joints", "home");
        const auto recovered = recoverFromBytes(bytes);
        QVERIFY(recovered.ok());
        QCOMPARE(recovered->document.waypoints.size(), 2);
        QCOMPARE(recovered->document.frames.size(), std::size_t(1));
        QCOMPARE(recovered->lostWaypoints, 1);
        QCOMPARE(recovered->problems.size(), 1);
        QCOMPARE(recovered->problems[0].where, QString("waypoints[1].joints"));
    }

    void aTruncatedFileLosesNoIntactWaypoint() {
        const Project document = sample(4);
        const QByteArray whole = bytesOf(document);
        QVERIFY(recoverFromBytes(whole)->problems.isEmpty());
        int mostRecovered = 0;
        for (qsizetype length = 0; length < whole.trimmed().size(); ++length) {
            const QByteArray cut = whole.left(length);
            QVERIFY(parseProject(cut).error().code == ErrorCode::FileCorrupt);
            const auto recovered = recoverFromBytes(cut);
            if (!recovered) {
                continue;
            }
            QVERIFY(!recovered->problems.isEmpty());
            for (int i = 0; i < recovered->document.waypoints.size(); ++i) {
                QVERIFY(recovered->document.waypoints.at(i) == document.waypoints.at(i));
            }
            // Number of complete entries in the text so far. Each entry ends with the last field of its move
            // kind.
            QVERIFY(recovered->document.waypoints.size() >= mostRecovered);
            mostRecovered = recovered->document.waypoints.size();
        }
        QCOMPARE(mostRecovered, 4);
    }

    void damageInTheMiddleLosesOneWaypoint() {
        const Project document = sample(3);
        QByteArray bytes = bytesOf(document);
        const qsizetype second = bytes.indexOf("\"joints\"", bytes.indexOf("\"joints\"") + 1);
        bytes.replace(second, 8, "\x01\x02 oops");
        const auto recovered = recoverFromBytes(bytes);
        QVERIFY(recovered.ok());
        QCOMPARE(recovered->lostWaypoints, 1);
        QCOMPARE(recovered->document.waypoints.size(), 2);
        QVERIFY(recovered->document.waypoints.at(0) == document.waypoints.at(0));
        QVERIFY(recovered->document.waypoints.at(1) == document.waypoints.at(2));
    }

    void anyChangedByteIsHandled() {
        const QByteArray whole = bytesOf(sample(1));
        for (qsizetype i = 0; i < whole.size(); ++i) {
            for (const char byte : {'\0', '{', '"', '\xc3'}) {
                QByteArray changed = whole;
                changed[i] = byte;
                (void)recoverFromBytes(changed);
                const auto parsed = parseProject(changed);
                QVERIFY(parsed.ok() || !parsed.error().context.isEmpty());
            }
        }
    }

    void largeProjectsAreReadAndExcessiveOnesRefused() {
        QVERIFY(saveProject(path_, sample(2000)).ok());
        QCOMPARE(loadProject(path_)->waypoints.size(), 2000);

        QFile file(path_);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.resize(kMaxProjectFileBytes + 1));  // a sparse file needs no disk space
        file.close();
        const auto loaded = loadProject(path_);
        QVERIFY(loaded.error().code == ErrorCode::FileCorrupt);
        QVERIFY(loaded.error().context.contains("64 MB"));
    }

    void damagedFileIsBackedUpBeforeItIsReplaced() {
        const QByteArray damaged = bytesOf(sample()).left(500);
        put(path_, damaged);
        const auto first = saveProject(path_, sample());
        QVERIFY2(first.ok(), qPrintable(first.error().toString()));
        QCOMPARE(first->keptCopy, path_ + ".damaged-1");
        QCOMPARE(contentOf(first->keptCopy), damaged);
        QVERIFY(loadProject(path_).ok());
        QVERIFY(saveProject(path_, sample())->keptCopy.isEmpty());

        put(path_, "something else");
        const auto second = saveProject(path_, sample());
        QCOMPARE(second->keptCopy, path_ + ".damaged-2");
        QCOMPARE(contentOf(second->keptCopy), QByteArray("something else"));
        QCOMPARE(contentOf(first->keptCopy), damaged);
    }

    void newerFileIsAlsoBackedUp() {
        QJsonObject root = QJsonDocument::fromJson(bytesOf(sample())).object();
        root["version"] = kProjectFileVersion + 1;
        put(path_, QJsonDocument(root).toJson());
        QVERIFY(!saveProject(path_, sample())->keptCopy.isEmpty());
    }

    void invalidValuesAreNotSavedAndKeepTheOldFile() {
        QVERIFY(saveProject(path_, sample()).ok());
        const QByteArray before = contentOf(path_);
        Project bad = sample();
        Waypoint point = bad.waypoints.at(1);
        point.pose.position.x() = std::numeric_limits<double>::quiet_NaN();
        bad.waypoints.replace(1, point);
        const auto saved = saveProject(path_, bad);
        QVERIFY(saved.error().code == ErrorCode::InvalidArgument);
        QVERIFY2(saved.error().context.contains("waypoints[1].pose[0]"), qPrintable(saved.error().context));
        QCOMPARE(contentOf(path_), before);
        point.pose.position.x() = 0;
        point.name.clear();
        bad.waypoints.replace(1, point);
        QVERIFY(saveProject(path_, bad).error().code == ErrorCode::InvalidArgument);
    }

    void missingFolderIsReported() {
        const auto saved = saveProject(directory_->filePath("no/such/folder/x.tiller"), sample());
        QVERIFY(saved.error().code == ErrorCode::FileNotWritable);
        QVERIFY(!saved.error().controllerMessage.isEmpty());
    }

    void aFailedWriteKeepsTheOldFile() {
#ifdef __linux__
        QVERIFY(saveProject(path_, sample()).ok());
        const QByteArray before = contentOf(path_);
        rlimit old{};
        QCOMPARE(getrlimit(RLIMIT_FSIZE, &old), 0);
        const rlimit tight{4096, old.rlim_max};
        const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &tight), 0);
        const auto saved = saveProject(path_, sample(200));
        setrlimit(RLIMIT_FSIZE, &old);
        std::signal(SIGXFSZ, ignored);
        QVERIFY(!saved.ok());
        QVERIFY(saved.error().code == ErrorCode::FileNotWritable ||
                saved.error().code == ErrorCode::DiskFull);
        QCOMPARE(contentOf(path_), before);
        QCOMPARE(QDir(directory_->path()).entryList(QDir::Files).size(), 1);
#else
        QSKIP("requires a file size limit");
#endif
    }

private:
    std::unique_ptr<QTemporaryDir> directory_;
    QString path_;
};

QTEST_GUILESS_MAIN(TestProjectFile)
#include "tst_project_file.moc"
