// SPDX-License-Identifier: MIT
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <numeric>
#include <random>

#include "robot/recording/formats/export_recording.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/hdf5/episodes.h"
#include "robot/recording/hdf5/hdf5_export.h"
#include "robot/recording/mcap/mcap_format.h"
#include "tests/unit/robot/recording/made_recording.h"

using namespace tiller;
using namespace tiller::recording;
using test::MadeSamples;

namespace {

constexpr std::uint64_t kRows = 1000;

std::unique_ptr<Recording> made(const QString& path, std::uint64_t gap = 0) {
    test::writeFile(path, test::madeFile(*mcapFormat({.facts = {{"model", "UR5e"}}}), kRows, gap));
    return openRecording(path).value();
}

void readAll(const Recording& recording) {
    std::vector<std::size_t> some(std::min<std::size_t>(recording.columns().size(), 10));
    std::iota(some.begin(), some.end(), std::size_t(0));
    constexpr std::uint64_t kSome = 5000;
    static_cast<void>(recording.read(some, {0, kSome}));
    static_cast<void>(recording.times({0, kSome}));
}

}  // namespace

class TestHdf5 : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void exportedDataAreReadBack();
    void logNotesAndMetadataAreExported();
    void anyColumnNameCanBeWritten();
    void partOfARecordingIsExported();
    void cancelledExportKeepsTheExistingFile();
    void brokenFilesAreReported();
    void filesOfOtherProgramsAreRead();
    void theTimeOfOtherProgramsIsRead_data();
    void theTimeOfOtherProgramsIsRead();
    void timesWithoutAColumnAreExported();
    void episodesByProgram();
    void episodesByNotes();
    void anExportWithoutEpisodesIsAnError();
    void aTextExportAlwaysHasTheTimeColumn();
    void headingsAreQuoted();
    void mcapExportIsReadBack();

private:
    QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
    QTemporaryDir folder_;
};

void TestHdf5::exportedDataAreReadBack() {
    const auto source = made(path("a.mcap"), 400);
    const auto report = exportHdf5(*source, {.path = path("a.h5")}).value();
    QCOMPARE(report.rows, kRows);
    QCOMPARE(report.bytes, QFileInfo(path("a.h5")).size());
    const auto back = openRecording(path("a.h5")).value();
    QVERIFY2(back->problems().isEmpty(), qPrintable(back->problems().join('\n')));
    QCOMPARE(back->format(), QStringLiteral("HDF5"));
    QCOMPARE(back->rows(), kRows);
    QCOMPARE(back->period(), source->period());
    QCOMPARE(back->facts().at("model"), std::string("UR5e"));
    QCOMPARE(back->gaps().size(), std::size_t(1));
    QCOMPARE(back->gaps().front().row, std::uint64_t(400));
    QCOMPARE(back->columns().size(), source->columns().size());
    for (const RecordedColumn& column : source->columns()) {
        const auto there = back->indexOf(column.name);
        QVERIFY2(there, column.name.c_str());
        QCOMPARE(back->columns()[*there].unit, column.unit);
        const auto expected = source->read(std::vector{*source->indexOf(column.name)}, {0, kRows}).value();
        QCOMPARE(back->read(std::vector{*there}, {0, kRows}).value(), expected);
    }
    QCOMPARE(back->times({0, kRows}).value(), source->times({0, kRows}).value());
    QCOMPARE(back->rowAt(1.0).value(), std::uint64_t(500));
    // Notes of a complete export, of a partial export, and of a partial export of the partial export.
    const auto noteIn = [&](const Recording& recording, double from, double until, const char* name) {
        const QString to = path(name);
        const auto exported = exportHdf5(recording, {.path = to, .from = from, .until = until});
        const auto part = exported ? openRecording(to) : Result<std::unique_ptr<Recording>>(exported.error());
        QStringList found(part ? part.value()->problems() : QStringList(part.error().toString()));
        for (const RecordedEvent& event : part ? part.value()->events() : std::vector<RecordedEvent>()) {
            found << QStringLiteral("%1 %2 %3 %4")
                         .arg(event.seconds, 0, 'f', 3)
                         .arg(event.level)
                         .arg(event.source, event.text);
        }
        return found.join(QStringLiteral(", "));
    };
    QCOMPARE(noteIn(*source, 0, 1e9, "whole.h5"), QString("1.000 30 operator half way"));
    QCOMPARE(noteIn(*source, 0.5, 1.2, "part.h5"), QString("0.500 30 operator half way"));
    QCOMPARE(noteIn(*openRecording(path("part.h5")).value(), 0.4, 0.6, "again.h5"),
             QString("0.100 30 operator half way"));
    QCOMPARE(noteIn(*source, 1.1, 1.2, "without.h5"), QString());
}

void TestHdf5::logNotesAndMetadataAreExported() {
    const auto format = mcapFormat({.facts = {{"operator", "Änne"}, {"sample", "7"}, {"", "no name"}}});
    QVERIFY(test::writeFile(path("log.mcap"), test::madeFile(*format, kRows)));
    const auto source = openRecording(path("log.mcap")).value();
    QCOMPARE(source->events().size(), std::size_t(1));
    exportHdf5(*source, {.path = path("log.h5")}).value();
    auto back = openRecording(path("log.h5")).value();
    QVERIFY2(back->problems().isEmpty(), qPrintable(back->problems().join('\n')));
    QCOMPARE(back->columns().size(), source->columns().size());
    QCOMPARE(back->startUtcNs(), source->startUtcNs());
    QCOMPARE(back->facts().at("operator"), std::string("Änne"));
    QCOMPARE(back->facts().at("sample"), std::string("7"));
    QCOMPARE(back->events().size(), std::size_t(1));
    const RecordedEvent& event = back->events().front();
    QCOMPARE(event.seconds, source->events().front().seconds);
    QCOMPARE(event.level, 30);
    QCOMPARE(event.source, QStringLiteral("operator"));
    QCOMPARE(event.text, QStringLiteral("half way"));

    // A part contains the events of its rows, relative to the start of the part.
    exportHdf5(*source, {.path = path("part.h5"), .from = 0.5}).value();
    back = openRecording(path("part.h5")).value();
    QCOMPARE(*back->startUtcNs(), *source->startUtcNs() + 500'000'000);
    QCOMPARE(back->events().size(), std::size_t(1));
    QVERIFY(std::abs(back->events().front().seconds - (source->events().front().seconds - 0.5)) < 1e-9);
    exportHdf5(*source, {.path = path("part.h5"), .until = 0.5}).value();
    back = openRecording(path("part.h5")).value();
    QVERIFY(back->problems().isEmpty() && back->events().empty());

    // Damaged notes do not affect the numbers.
    if (QProcess::execute("/usr/bin/python3", {"-c", "import h5py"}) != 0) {
        QSKIP("h5py is not installed (python3-h5py)");
    }
    const char* script =
        "import h5py, sys\n"
        "f = h5py.File(sys.argv[1], 'r+')\n"
        "e = f['notes']\n"
        "assert [t.decode() for t in e['text']] == ['half way'] and list(e['level']) == [30]\n"
        "assert f.attrs['operator'].decode() == 'Änne'\n"
        "del e['source']\n";
    QCOMPARE(QProcess::execute("/usr/bin/python3", {"-c", script, path("log.h5")}), 0);
    back = openRecording(path("log.h5")).value();
    QCOMPARE(back->rows(), kRows);
    QVERIFY(back->events().empty());
}

void TestHdf5::anyColumnNameCanBeWritten() {
    QTemporaryDir folder;
    const QString from = folder.filePath("names.csv");
    // A duplicate name, an empty name, names that HDF5 does not accept, and a name that the file already
    // uses.
    test::writeFile(from,
                    "timestamp,a_0,b,a_0,,.,..,0.0,0.0,time,actual_q_0,b/c,actual_q_0,\n"
                    "0.002,1.5,2,3.5,4,5,6,7,8,9,10,11,12,13\n0.004,1,2,3,4,5,6,7,8,9,10,11,12,13\n");
    const auto recording = openRecording(from).value();
    ExportChoice choice;
    choice.path = folder.filePath("names.h5");
    const auto written = exportHdf5(*recording, choice);
    QVERIFY2(written.ok(), written.ok() ? "" : qPrintable(written.error().toString()));
    const auto back = openRecording(choice.path).value();
    QCOMPARE(back->rows(), std::uint64_t(2));
    // All values of the first row are present, regardless of the column names.
    std::vector<double> values;
    for (std::size_t i = 0; i < back->columns().size(); ++i) {
        values.push_back(back->read(std::vector{i}, {0, 1}).value().front().front());
    }
    for (const double value : {1.5, 2.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0}) {
        QVERIFY2(std::find(values.begin(), values.end(), value) != values.end(),
                 qPrintable(QString::number(value)));
    }
}

void TestHdf5::partOfARecordingIsExported() {
    const auto source = made(path("b.mcap"));
    ExportChoice choice{
        .path = path("b.h5"), .columns = {"actual_q", "robot_mode"}, .from = 0.5, .until = 0.6};
    QCOMPARE(exportHdf5(*source, choice).value().rows, std::uint64_t(51));
    const auto back = openRecording(path("b.h5")).value();
    QCOMPARE(back->columns().size(), std::size_t(7));
    choice.columns = {"actual_qq"};
    QCOMPARE(exportHdf5(*source, choice).error().code, ErrorCode::FieldUnknown);
    QVERIFY(openRecording(path("b.h5")).ok());
}

void TestHdf5::cancelledExportKeepsTheExistingFile() {
    const auto source = made(path("c.mcap"));
    QVERIFY(test::writeFile(path("c.h5"), "precious"));
    ExportChoice choice{.path = path("c.h5")};
    choice.progress = [](double) { return false; };
    QCOMPARE(exportHdf5(*source, choice).error().code, ErrorCode::Cancelled);
    QCOMPARE(QFileInfo(path("c.h5")).size(), qint64(8));
    QVERIFY(!QFileInfo::exists(path("c.h5.part")));
    choice = {.path = path("no/such/folder.h5")};
    QCOMPARE(exportHdf5(*source, choice).error().code, ErrorCode::FileNotWritable);
    QCOMPARE(exportCsv(*source, {.path = path("no/such/folder.csv")}).error().code,
             ErrorCode::FileNotWritable);
}

// libhdf5 itself does not withstand arbitrary damage. The mutations are therefore limited to the damage that
// a disk or a transfer can cause.
void TestHdf5::brokenFilesAreReported() {
    const auto source = made(path("d.mcap"));
    exportHdf5(*source, {.path = path("d.h5"), .columns = {"actual_q", "robot_mode"}}).value();
    QFile file(path("d.h5"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const std::string whole = file.readAll().toStdString();
    std::mt19937 random(5);
    for (int i = 0; i < 1000; ++i) {
        std::string bytes = whole;
        if (i % 3 == 0) {
            bytes.resize(random() % bytes.size());
        }
        for (unsigned change = 0; change < 1 + random() % 5 && !bytes.empty(); ++change) {
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        QVERIFY(test::writeFile(path("mutated.h5"), bytes));
        if (const auto recording = openRecording(path("mutated.h5"))) {
            readAll(**recording);
        } else {
            QVERIFY(!recording.error().toString().isEmpty());
        }
    }
}

void TestHdf5::filesOfOtherProgramsAreRead() {
    if (QProcess::execute("/usr/bin/python3", {"-c", "import h5py"}) != 0) {
        QSKIP("h5py is not installed (python3-h5py)");
    }
    const char* script =
        "import h5py, sys, numpy\n"
        "f = h5py.File(sys.argv[1], 'w')\n"
        "f['time'] = numpy.arange(10) * 0.1 + 5\n"
        "f['force'] = numpy.arange(20, dtype='f4').reshape(10, 2)\n"
        "f['force'].attrs['unit'] = 'N'\n"
        "f['count'] = numpy.arange(10, dtype='i2')\n"
        "f['names'] = ['a', 'b']\n"
        "f['short'] = [1.0, 2.0]\n"
        "f.create_group('more')\n";
    QCOMPARE(QProcess::execute("/usr/bin/python3", {"-c", script, path("o.h5")}), 0);
    const auto recording = openRecording(path("o.h5")).value();
    QCOMPARE(recording->rows(), std::uint64_t(10));
    QCOMPARE(recording->columns().size(), std::size_t(3));
    QCOMPARE(recording->read(std::vector{*recording->indexOf("force_1")}, {9, 1}).value().front().front(),
             19.0);
    QVERIFY(recording->columns()[*recording->indexOf("count")].whole);
    QVERIFY(std::abs(recording->times({9, 1}).value().front() - 0.9) < 1e-9);
    QCOMPARE(recording->problems().size(), 3);
}

// Each file has three rows that are 10 ms apart, and the forces 1.5, -2.5 and 3.5, unless an error is
// expected.
void TestHdf5::theTimeOfOtherProgramsIsRead_data() {
    QTest::addColumn<QString>("script");
    QTest::addColumn<QString>("force");
    QTest::addColumn<QString>("error");
    const auto row = [](const char* name, const char* script, const char* force, const char* error = "") {
        QTest::newRow(name) << QString(script) << QString(force) << QString(error);
    };
    row("time in a group", "f['run/t_ms'] = [5000, 5010, 5020]; f['run/force'] = F", "run/force");
    row("unit in an attribute",
        "f['time'] = [5000, 5010, 5020]; f['time'].attrs['units'] = 'ms'; f['force'] = F", "force");
    row("Unix nanoseconds",
        "f['a/stamp'] = [1716969600100000000 + i * 10000000 for i in range(3)]; f['a/force'] = F", "a/force");
    row("Octave",
        "f['t/type'] = numpy.bytes_('matrix'); f['t/value'] = numpy.array([[0, 0.01, 0.02]])\n"
        "f['force/type'] = numpy.bytes_('matrix'); f['force/value'] = numpy.array([F, [0, 0, 0]])",
        "force_0");
    row("MATLAB",
        "f['t'] = numpy.array([[0, 0.01, 0.02]]).T; f['force'] = numpy.array([F, [0, 0, 0]])\n"
        "f['t'].attrs['MATLAB_class'] = f['force'].attrs['MATLAB_class'] = numpy.bytes_('double')",
        "force_0");
    row("no time", "f['force'] = F", "", "time-column");
    row("two times", "f['a/t'] = [0, 0.01, 0.02]; f['b/t'] = [0, 0.01, 0.02]; f['force'] = F", "", "a/t");
    row("no unit", "f['time'] = [5000, 5010, 5020]; f['force'] = F", "", "time-unit");
}

void TestHdf5::theTimeOfOtherProgramsIsRead() {
    if (QProcess::execute("/usr/bin/python3", {"-c", "import h5py"}) != 0) {
        QSKIP("h5py is not installed (python3-h5py)");
    }
    QFETCH(QString, script);
    QFETCH(QString, force);
    QFETCH(QString, error);
    script = "import h5py, numpy, sys\nF = [1.5, -2.5, 3.5]\nf = h5py.File(sys.argv[1], 'w')\n" + script;
    QCOMPARE(QProcess::execute("/usr/bin/python3", {"-c", script, path("t.h5")}), 0);
    const auto opened = openRecording(path("t.h5"));
    if (!error.isEmpty()) {
        QVERIFY(!opened.ok());
        QCOMPARE(opened.error().code, ErrorCode::InvalidArgument);
        QVERIFY2(opened.error().controllerMessage.contains(error), qPrintable(opened.error().toString()));
        return;
    }
    QVERIFY2(opened.ok(), opened.ok() ? "" : qPrintable(opened.error().toString()));
    const Recording& recording = **opened;
    QVERIFY2(recording.problems().isEmpty(), qPrintable(recording.problems().join(' ')));
    QCOMPARE(recording.rows(), std::uint64_t(3));
    const auto column = recording.indexOf(force.toStdString());
    QVERIFY(column);
    QCOMPARE(recording.read(std::vector{*column}, {0, 3}).value().front(), (std::vector{1.5, -2.5, 3.5}));
    const std::vector<double> times = recording.times({1, 2}).value();
    QVERIFY(std::abs(times[0] - 0.01) < 1e-6 && std::abs(times[1] - 0.02) < 1e-6);
}

// In an HDF5 export, the time is not a column. A text file exported from it must still contain the time.
void TestHdf5::timesWithoutAColumnAreExported() {
    const auto source = made(path("n.mcap"));
    exportHdf5(*source, {.path = path("n.h5"), .columns = {"actual_q"}}).value();
    const auto table = openRecording(path("n.h5")).value();
    QVERIFY(!table->timeColumn());
    exportCsv(*table, {.path = path("n.csv"), .columns = {"actual_q_0"}, .from = 0.5}).value();
    const auto back = openRecording(path("n.csv")).value();
    QCOMPARE(back->columns().size(), std::size_t(2));
    QCOMPARE(back->columns().front().name, std::string("time"));
    const auto times = table->times({250, 2}).value();
    QCOMPARE(back->read(std::vector<std::size_t>{0}, {0, 2}).value().front(), times);
    QCOMPARE(back->times({0, 2}).value(), (std::vector{0, times[1] - times[0]}));
}

void TestHdf5::episodesByProgram() {
    // Two programs of 200 rows each, with pauses of 100 rows.
    MadeSamples samples;
    std::vector<std::string> fields;
    for (const auto& entry : samples.layout->entries()) {
        fields.push_back(entry.name);
    }
    const std::size_t state = samples.layout->indexOfComponent("runtime_state").value();
    const auto encoder = mcapFormat()->encoder({samples.layout, fields, false});
    for (std::uint64_t row = 0; row < 1000; ++row) {
        receive::Sample sample = samples.at(row);
        sample.values[state] = (row >= 100 && row < 300) || (row >= 400 && row < 650) || row == 900 ? 2 : 1;
        encoder->add(sample, 0, samples.utcNs(row));
    }
    QVERIFY(test::writeFile(path("e.mcap"), encoder->take(RecordingEncoder::Close::Last).bytes));
    const auto recording = openRecording(path("e.mcap")).value();
    const auto found = findEpisodes(*recording, EpisodeChoice::Cut::Program).value();
    QCOMPARE(found.size(), std::size_t(3));
    QCOMPARE(found[1].rows.first, std::uint64_t(400));
    QCOMPARE(found[1].rows.count, std::uint64_t(250));
    EpisodeChoice choice;
    choice.shortest = 0.1;
    const auto report = writeEpisodes({recording.get(), recording.get()}, path("e.h5"), choice).value();
    QCOMPARE(report.episodes, 4);
    QCOMPARE(report.tooShort, 2);
    QCOMPARE(report.rows, std::uint64_t(2 * (8 + 10)));
    if (QProcess::execute("/usr/bin/python3", {"-c", "import h5py"}) != 0) {
        QSKIP("h5py is not installed (python3-h5py)");
    }
    const char* script =
        "import h5py, json, sys\n"
        "f = h5py.File(sys.argv[1])\n"
        "assert json.loads(f['data'].attrs['env_args'])['env_name']\n"
        "assert f['data'].attrs['total'] == 36\n"
        "d = f['data/demo_3']\n"
        "assert d.attrs['num_samples'] == 10\n"
        "assert d['obs/actual_q'].shape == d['next_obs/actual_q'].shape == (10, 6)\n"
        "assert (d['obs/actual_q'][1:] == d['next_obs/actual_q'][:-1]).all()\n"
        "assert d['actions'].shape == (10, 6) and d['dones'][-1] == 1 and d['rewards'].shape == (10,)\n";
    QCOMPARE(QProcess::execute("/usr/bin/python3", {"-c", script, path("e.h5")}), 0);
}

void TestHdf5::anExportWithoutEpisodesIsAnError() {
    const auto recording = made(path("f.mcap"));
    EpisodeChoice choice;
    choice.cut = EpisodeChoice::Cut::Whole;
    choice.shortest = 1000;
    QCOMPARE(writeEpisodes({recording.get()}, path("f.h5"), choice).error().code, ErrorCode::InvalidArgument);
    QVERIFY(!QFileInfo::exists(path("f.h5")));
    choice.shortest = 0;
    choice.observations = {"actual_qq"};
    QCOMPARE(writeEpisodes({recording.get()}, path("f.h5"), choice).error().code, ErrorCode::FieldUnknown);
}

void TestHdf5::episodesByNotes() {
    MadeSamples samples;
    std::vector<std::string> fields;
    for (const auto& entry : samples.layout->entries()) {
        fields.push_back(entry.name);
    }
    const auto file = [&](const char* name, const std::vector<RecordedNote>& notes) {
        const auto encoder =
            mcapFormat({.facts = {{"written_by", "tiller 1.0"}}})->encoder({samples.layout, fields, false});
        for (std::uint64_t row = 0; row < kRows; ++row) {
            encoder->add(samples.at(row), 0, samples.utcNs(row));
        }
        for (const RecordedNote& note : notes) {
            encoder->add(note);
        }
        test::writeFile(path(name), encoder->take(RecordingEncoder::Close::Last).bytes);
        return openRecording(path(name)).value();
    };
    const RecordedNote line{samples.utcNs(100), 20, "operator", "Recording to a.mcap"};
    // Log lines of the operator do not count as notes.
    auto recording = file("notes.mcap", {line,
                                         {samples.utcNs(300), 20, "note", "first"},
                                         {samples.utcNs(500), 20, "operator", "Force zeroed"},
                                         {samples.utcNs(700), 20, "note", "second"}});
    const auto found = findEpisodes(*recording, EpisodeChoice::Cut::Notes).value();
    QCOMPARE(found.size(), std::size_t(2));
    QCOMPARE(found[0].name, QStringLiteral("first"));
    QCOMPARE(found[0].rows.first, std::uint64_t(300));
    QCOMPARE(found[0].rows.count, std::uint64_t(400));
    QCOMPARE(found[1].rows.first, std::uint64_t(700));
    // A file written by an earlier version.
    recording = file("old.mcap", {line, {samples.utcNs(300), 20, "operator", "Notiz: hier"}});
    const auto old = findEpisodes(*recording, EpisodeChoice::Cut::Notes).value();
    QCOMPARE(old.size(), std::size_t(1));
    QCOMPARE(old[0].rows.first, std::uint64_t(300));
    recording = file("without.mcap", {line});
    QVERIFY(findEpisodes(*recording, EpisodeChoice::Cut::Notes).value().empty());
}

void TestHdf5::aTextExportAlwaysHasTheTimeColumn() {
    const auto source = made(path("time.mcap"));
    exportCsv(*source, {.path = path("time.csv"), .columns = {"actual_q"}, .from = 1, .until = 1.1}).value();
    const auto back = openRecording(path("time.csv")).value();
    QCOMPARE(back->columns().size(), std::size_t(7));
    QCOMPARE(back->columns().front().name, std::string("timestamp"));
    const std::vector<std::size_t> first{0};
    QCOMPARE(back->read(first, {0, back->rows()}).value(),
             source->read(std::vector{*source->indexOf("timestamp")}, {500, back->rows()}).value());
}

void TestHdf5::headingsAreQuoted() {
    const std::string name = "|F| = norm({a \"b\".csv/x}, {c})";
    test::writeFile(path("from.csv"),
                    "timestamp [s],\"|F| = norm({a \"\"b\"\".csv/x}, {c})\"\n1.5,2\n3.75,4\n");
    const auto source = openRecording(path("from.csv")).value();
    QCOMPARE(source->columns().size(), std::size_t(2));
    QCOMPARE(source->columns().back().name, name);
    exportCsv(*source, {.path = path("quoted.csv")}).value();
    const auto back = openRecording(path("quoted.csv")).value();
    QCOMPARE(back->columns().size(), std::size_t(2));
    QCOMPARE(back->columns().back().name, name);
    QCOMPARE(back->rows(), std::uint64_t(2));
}

void TestHdf5::mcapExportIsReadBack() {
    const auto source = made(path("source.mcap"), 400);
    const auto report =
        exportRecording(*source, {.path = path("part.mcap"), .from = 0.2, .until = 1.4}).value();
    QCOMPARE(report.rows, std::uint64_t(601));
    const auto back = openRecording(path("part.mcap")).value();
    QVERIFY2(back->problems().isEmpty(), qPrintable(back->problems().join('\n')));
    QCOMPARE(back->rows(), report.rows);
    QCOMPARE(back->facts(), source->facts());
    QCOMPARE(back->columns().size(), source->columns().size());
    for (const RecordedColumn& column : source->columns()) {
        const auto there = back->indexOf(column.name);
        QVERIFY2(there, column.name.c_str());
        QCOMPARE(back->columns()[*there].unit, column.unit);
        QCOMPARE(back->columns()[*there].whole, column.whole);
        const std::vector<std::size_t> from{*source->indexOf(column.name)};
        const auto expected = source->read(from, {100, report.rows}).value();
        QCOMPARE(back->read(std::vector{*there}, {0, report.rows}).value(), expected);
    }
    QCOMPARE(back->gaps().size(), std::size_t(1));
    QCOMPARE(back->gaps().front().row, std::uint64_t(300));
    QCOMPARE(back->gaps().front().packets, std::uint64_t(5));
    QCOMPARE(*back->startUtcNs(), *source->startUtcNs() + 200'000'000);
    QCOMPARE(back->events().size(), std::size_t(1));
    QVERIFY(std::abs(back->events().front().seconds - (source->events().front().seconds - 0.2)) < 1e-6);
}

QTEST_GUILESS_MAIN(TestHdf5)
#include "tst_hdf5.moc"
