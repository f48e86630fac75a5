// SPDX-License-Identifier: MIT
#include "robot/recording/csv_recording.h"

#include <QFile>
#include <charconv>
#include <cmath>
#include <limits>

#include "robot/core/file_reading.h"
#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/detail/csv_notes.h"
#include "robot/recording/table_recording.h"

namespace tiller::recording {

namespace {

constexpr qint64 kReadAtOnce = 1 << 20;
// A file with more columns is not a robot recording.
constexpr std::size_t kMaxColumns = 20'000;
constexpr std::size_t kMaxLineLength = 16u << 20;
constexpr int kMaxProblems = 20;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string_view withoutBlanks(std::string_view cell) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!cell.empty() && blank(cell.front())) {
        cell.remove_prefix(1);
    }
    while (!cell.empty() && blank(cell.back())) {
        cell.remove_suffix(1);
    }
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
        cell = cell.substr(1, cell.size() - 2);
    }
    return cell;
}

/// Calls sink(cell) for every cell; quoted cells may contain separators.
template <class Sink>
void splitLine(std::string_view line, char separator, Sink sink) {
    for (;;) {
        std::size_t from = 0;
        if (!line.empty() && line.front() == '"') {
            // A doubled quote is part of the cell.
            std::size_t closed = line.find('"', 1);
            while (closed != std::string_view::npos && line.substr(closed).starts_with("\"\"")) {
                closed = line.find('"', closed + 2);
            }
            from = closed == std::string_view::npos ? 0 : closed;
        }
        const std::size_t end = line.find(separator, from);
        sink(withoutBlanks(line.substr(0, end)));
        if (end == std::string_view::npos) {
            return;
        }
        line.remove_prefix(end + 1);
    }
}

/// Splits cells at one or more blanks. A unit in brackets belongs to the preceding name.
std::vector<std::string_view> blankSeparated(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t begin = line.find_first_not_of(" \t"); begin != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
        if (line[begin] == '[' && !cells.empty()) {
            const char* const first = cells.back().data();
            cells.back() = {first, static_cast<std::size_t>(line.data() + end - first)};
        } else {
            cells.push_back(line.substr(begin, end - begin));
        }
        begin = line.find_first_not_of(" \t", end);
    }
    return cells;
}

char separatorOf(std::string_view heading) {
    char best = ',';
    std::ptrdiff_t most = 0;
    for (const char candidate : {',', ';', '\t', '|'}) {
        std::ptrdiff_t count = 0;
        bool quoted = false;
        for (const char c : heading) {
            quoted = quoted != (c == '"');
            count += !quoted && c == candidate ? 1 : 0;
        }
        if (count > most) {
            best = candidate;
            most = count;
        }
    }
    return best;
}

bool hasControlCharacters(std::string_view line) {
    return std::any_of(line.begin(), line.end(), [](char c) { return c >= 0 && c < ' ' && c != '\t'; });
}

/// Accepts "0.5", "+3", "1e-3", and "0,5" if the comma does not separate cells. An empty cell, "nan" and
/// similar become NaN.
bool numberOf(std::string_view cell, bool commaMayBePoint, double& value) {
    if (cell.empty()) {
        value = kNone;
        return true;
    }
    if (cell.front() == '+') {
        cell.remove_prefix(1);
    }
    const char* const last = cell.data() + cell.size();
    auto [end, failure] = std::from_chars(cell.data(), last, value);
    if (failure == std::errc() && end == last) {
        return true;
    }
    if (commaMayBePoint && cell.size() < 64 && std::count(cell.begin(), cell.end(), ',') == 1) {
        char text[64];
        std::replace_copy(cell.begin(), cell.end(), text, ',', '.');
        const auto again = std::from_chars(text, text + cell.size(), value);
        return again.ec == std::errc() && again.ptr == text + cell.size();
    }
    if (cell == "True" || cell == "true" || cell == "False" || cell == "false") {
        value = cell.front() == 'T' || cell.front() == 't' ? 1 : 0;
        return true;
    }
    return false;
}

/// Parses a header cell: "actual_q_0 [rad]" is the column "actual_q_0" with the unit "rad".
RecordedColumn columnFrom(std::string_view heading) {
    RecordedColumn column;
    column.name = std::string(heading);
    for (std::size_t at = column.name.find("\"\""); at != std::string::npos;
         at = column.name.find("\"\"", at + 1)) {
        column.name.erase(at, 1);
    }
    if (const std::size_t open = heading.rfind('[');
        open != std::string_view::npos && open > 0 && heading.back() == ']') {
        column.name = std::string(withoutBlanks(heading.substr(0, open)));
        column.unit = std::string(heading.substr(open + 1, heading.size() - open - 2));
    }
    return column;
}

class CsvParser {
public:
    explicit CsvParser(const QString& path) { table_.path = path; }

    Result<std::unique_ptr<Recording>> parse(QFile& file) {
        table_.format = QStringLiteral("CSV");
        std::string rest;
        while (!file.atEnd()) {
            const QByteArray part = file.read(kReadAtOnce);
            if (part.isEmpty()) {
                break;
            }
            rest.append(part.constData(), static_cast<std::size_t>(part.size()));
            std::size_t begin = 0;
            for (std::size_t end = rest.find('\n'); end != std::string::npos; end = rest.find('\n', begin)) {
                takeLine(std::string_view(rest).substr(begin, end - begin));
                begin = end + 1;
            }
            rest.erase(0, begin);
            if (rest.size() > kMaxLineLength || table_.columns.size() > kMaxColumns || isBinary_) {
                return failure(QStringLiteral("the file is not a table of numbers"));
            }
        }
        if (file.error() != QFileDevice::NoError) {
            return Error{ErrorCode::FileNotReadable, table_.path, file.errorString()};
        }
        if (!rest.empty()) {
            takeLine(rest);
            problem(QStringLiteral("The last line is incomplete: its last number may be truncated."));
        }
        if (isBinary_) {
            return failure(QStringLiteral("the file is not a table of numbers"));
        }
        if (table_.columns.empty()) {
            return failure(QStringLiteral("the file has no header"));
        }
        if (rows_ == 0 && number_ > (isHeaded_ ? 2u : 1u)) {
            return failure(QStringLiteral("the file contains no numbers below the header"));
        }
        finish();
        table_.notes = readCsvNotes(table_.path);
        return std::unique_ptr<Recording>(std::make_unique<TableRecording>(std::move(table_)));
    }

private:
    Error failure(const QString& what) const { return {ErrorCode::FileCorrupt, table_.path, what}; }

    void problem(const QString& sentence) {
        if (table_.problems.size() < kMaxProblems) {
            table_.problems << sentence;
        } else {
            ++unsaid_;
        }
    }

    void takeLine(std::string_view line) {
        ++number_;
        if (!line.empty() && line.back() == '\r') {
            line.remove_suffix(1);
        }
        // Text files contain no control characters. Only the first line is checked.
        if (rows_ == 0 && hasControlCharacters(line)) {
            isBinary_ = true;
            return;
        }
        if (table_.columns.empty()) {
            takeHeading(line);
            return;
        }
        if (withoutBlanks(line).empty() || line.front() == '#') {
            return;
        }
        if (rows_ == 0 && table_.columns.size() == 1) {
            separateByBlanks(line);
        }
        row_.clear();
        std::size_t numbers = 0;
        wrong_.clear();
        const auto takeCell = [&](std::string_view cell) {
            double value = kNone;
            if (numberOf(cell, separator_ != ',', value)) {
                numbers += cell.empty() ? 0 : 1;
            } else {
                wrong_.push_back(row_.size());
                value = kNone;
            }
            row_.push_back(value);
        };
        if (separator_ == ' ') {
            std::ranges::for_each(blankSeparated(line), takeCell);
        } else {
            splitLine(line, separator_, takeCell);
        }
        if (numbers == 0 && rows_ == 0 && !isHeaded_ && !wrong_.empty()) {
            takeUnits(line);
            return;
        }
        if (numbers == 0 && !wrong_.empty()) {
            problem(QStringLiteral("Line %1 is skipped: it contains no number.").arg(number_));
            return;
        }
        if (row_.size() != table_.columns.size()) {
            problem(QStringLiteral("Line %1 is skipped: it has %2 cells, the header has %3.")
                        .arg(number_)
                        .arg(row_.size())
                        .arg(table_.columns.size()));
            return;
        }
        for (const std::size_t column : wrong_) {
            ++notNumbers_[column];
        }
        for (std::size_t i = 0; i < row_.size(); ++i) {
            table_.values[i].push_back(row_[i]);
        }
        ++rows_;
    }

    void takeHeading(std::string_view line) {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (number_ == 1 && line.starts_with(kByteOrderMark)) {
            line.remove_prefix(kByteOrderMark.size());
        }
        if (withoutBlanks(line).empty()) {
            return;
        }
        if (line.front() == '#') {
            line.remove_prefix(1);
        }
        separator_ = separatorOf(line);
        heading_ = line;
        splitLine(line, separator_,
                  [&](std::string_view cell) { table_.columns.push_back(columnFrom(cell)); });
        table_.values.resize(table_.columns.size());
        notNumbers_.resize(table_.columns.size());
    }

    /// Cells are separated by blanks if the header and the first row have the same number of blank-separated
    /// parts, at least two.
    void separateByBlanks(std::string_view line) {
        const auto headings = blankSeparated(heading_);
        if (headings.size() < 2 || blankSeparated(line).size() != headings.size()) {
            return;
        }
        separator_ = ' ';
        table_.columns.clear();
        for (const std::string_view cell : headings) {
            table_.columns.push_back(columnFrom(cell));
        }
        table_.values.resize(headings.size());
        notNumbers_.resize(headings.size());
    }

    void takeUnits(std::string_view line) {
        isHeaded_ = true;
        std::size_t column = 0;
        splitLine(line, separator_, [&](std::string_view cell) {
            if (column < table_.columns.size()) {
                table_.columns[column++].unit = cell == "-" ? std::string() : std::string(cell);
            }
        });
    }

    void finish() {
        for (std::size_t i = 0; i < table_.columns.size(); ++i) {
            addKnowledge(table_.columns[i]);
            if (notNumbers_[i] > 0) {
                problem(QStringLiteral("Column \"%1\": %2 cells are not numbers.")
                            .arg(QString::fromStdString(table_.columns[i].name))
                            .arg(notNumbers_[i]));
            }
        }
        if (unsaid_ > 0) {
            table_.problems << QStringLiteral("There are %1 more problems of this kind.").arg(unsaid_);
        }
    }

    RecordedTable table_;
    char separator_ = ',';
    std::string heading_{};
    std::size_t number_ = 0;  ///< line number
    std::size_t rows_ = 0;
    bool isHeaded_ = false;  ///< true after the line of units
    bool isBinary_ = false;
    std::vector<double> row_;
    std::vector<std::size_t> wrong_;
    std::vector<std::size_t> notNumbers_;
    std::size_t unsaid_ = 0;
};

}  // namespace

Result<std::unique_ptr<Recording>> openCsv(const Text& path) {
    QFile file;
    if (const Result<void> opened = openForReading(file, path); !opened) {
        return opened.error();
    }
    return CsvParser(path).parse(file);
}

}  // namespace tiller::recording
