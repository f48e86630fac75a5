// SPDX-License-Identifier: MIT
#include "robot/recording/csv_recording.h"

#include <QFile>
#include <QStringDecoder>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "robot/core/file_reading.h"
#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/detail/csv_head.h"
#include "robot/recording/detail/csv_notes.h"
#include "robot/recording/detail/time_axis.h"
#include "robot/recording/table_recording.h"

namespace tiller::recording {

namespace {

constexpr qint64 kReadAtOnce = 1 << 20;
// A file with more columns is not a robot recording.
constexpr std::size_t kMaxColumns = 20'000;
constexpr std::size_t kMaxLineLength = 16u << 20;
constexpr int kMaxProblems = 20;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMaxSampledLines = 40;
constexpr char kBlanks = ' ';        // separator: any number of blanks
constexpr char kNoSeparator = '\0';  // a single column

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

/// The most frequent separator in a line.
char separatorOf(std::string_view heading) {
    char best = kNoSeparator;
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

/// decimal  '\0': point or comma; the first number that contains one of them determines the decimal
///          separator. Numbers with the other separator are rejected, because it could be a thousands
///          separator.
bool numberOf(std::string_view cell, char& decimal, double& value) {
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
        if (decimal != '.' && cell.find('.') != std::string_view::npos) {
            decimal = decimal == '\0' ? '.' : decimal;
            return decimal == '.';
        }
        return true;
    }
    if (decimal != '.' && cell.size() < 64 && std::count(cell.begin(), cell.end(), ',') == 1 &&
        cell.find('.') == std::string_view::npos) {
        char text[64];
        std::replace_copy(cell.begin(), cell.end(), text, ',', '.');
        const auto again = std::from_chars(text, text + cell.size(), value);
        if (again.ec == std::errc() && again.ptr == text + cell.size()) {
            decimal = ',';
            return true;
        }
        return false;
    }
    if (cell == "True" || cell == "true" || cell == "False" || cell == "false") {
        value = cell.front() == 'T' || cell.front() == 't' ? 1 : 0;
        return true;
    }
    return false;
}

/// Text in an encoding other than UTF-8 is read as Latin-1.
std::string utf8(std::string_view text) {
    const auto size = static_cast<qsizetype>(text.size());
    QStringDecoder decoder(QStringDecoder::Utf8);
    const QString decoded = decoder(QByteArrayView(text.data(), size));
    return decoder.hasError() ? QString::fromLatin1(text.data(), size).toStdString() : std::string(text);
}

/// Parses a header cell: "actual_q_0 [rad]" is the column "actual_q_0" with the unit "rad".
RecordedColumn columnFrom(std::string_view heading) {
    RecordedColumn column;
    column.name = utf8(heading);
    for (std::size_t at = column.name.find("\"\""); at != std::string::npos;
         at = column.name.find("\"\"", at + 1)) {
        column.name.erase(at, 1);
    }
    if (const std::size_t open = heading.rfind('[');
        open != std::string_view::npos && open > 0 && heading.back() == ']') {
        column.name = utf8(withoutBlanks(heading.substr(0, open)));
        column.unit = utf8(heading.substr(open + 1, heading.size() - open - 2));
    }
    return column;
}

/// Splits a line at the separator, which may be kBlanks or kNoSeparator.
std::vector<std::string_view> cellsOf(std::string_view line, char separator) {
    if (separator == kBlanks) {
        return blankSeparated(line);
    }
    std::vector<std::string_view> cells;
    if (separator == kNoSeparator) {
        cells.push_back(withoutBlanks(line));
    } else {
        splitLine(line, separator, [&cells](std::string_view cell) { cells.push_back(cell); });
    }
    return cells;
}

/// True for comment lines as written by Octave, gnuplot and numpy, but not for "%time", a heading of ROS.
bool isComment(std::string_view line) {
    return line.starts_with('#') || line.starts_with("% ") || line.starts_with("%%");
}

std::string_view withoutLineEnd(std::string_view line) {
    if (!line.empty() && line.back() == '\r') {
        line.remove_suffix(1);
    }
    return line;
}

bool isNumber(std::string_view cell) {
    char decimal = '\0';
    double value = 0;
    DateKind kind{};
    return !cell.empty() && (numberOf(cell, decimal, value) || parseDate(cell, value, kind));
}

/// The form of a text table, found in its first lines.
struct TextLayout {
    char separator = kNoSeparator;
    char decimal = '\0';  ///< '\0': the first number with a decimal separator decides
    bool hasHeader = true;
    std::string headingInComment{};  ///< header in a comment line; if set, `hasHeader` is false
};

class LayoutFinder {
public:
    LayoutFinder(std::string_view text, const QString& path, const TableFormat& format)
        : path_(path), format_(format) {
        std::string_view comment;
        for (std::size_t begin = 0; begin < text.size() && lines_.size() < kMaxSampledLines;) {
            const std::size_t end = text.find('\n', begin);
            const std::string_view line = withoutLineEnd(text.substr(begin, end - begin));
            begin = end == std::string_view::npos ? text.size() : end + 1;
            if (isComment(line)) {
                comment = line.substr(std::min(line.find_first_not_of("#%"), line.size()));
            } else if (line.size() == 5 && line.starts_with("sep=") && lines_.empty()) {
                layout_.separator = line.back();  // spreadsheet programs read the separator from this line
            } else if (!withoutBlanks(line).empty()) {
                comment_ = lines_.empty() ? comment : comment_;
                lines_.push_back(line);
            }
        }
    }

    Result<TextLayout> run() {
        layout_.separator = format_.separator.value_or(
            layout_.separator != kNoSeparator || lines_.empty() ? layout_.separator : separatorOfLines());
        layout_.decimal = format_.decimal.value_or(layout_.separator == ',' ? '.' : '\0');
        findHeader();
        if (!layout_.hasHeader && layout_.headingInComment.empty() && isCommaUnclear()) {
            return Error{
                ErrorCode::InvalidArgument, path_,
                QStringLiteral("the comma in \"%1\" may separate two columns or be a decimal separator. "
                               "Specify --table-separator or --table-decimal")
                    .arg(QString::fromUtf8(lines_.front().data(),
                                           static_cast<qsizetype>(lines_.front().size())))};
        }
        return layout_;
    }

private:
    /// The separator for which most lines have as many cells as the first line, and most cells are numbers.
    char separatorOfLines() const {
        if (lines_.size() == 1 &&
            !isNumber(lines_.front().substr(0, lines_.front().find_first_of(",;\t| ")))) {
            return separatorOf(lines_.front());
        }
        char best = kNoSeparator;
        double bestScore = 0;
        for (const char candidate : {'\t', ';', '|', ',', kBlanks}) {
            if (format_.decimal && candidate == *format_.decimal) {
                continue;
            }
            const std::size_t count = cellsOf(lines_.front(), candidate).size();
            std::size_t alike = 0;
            std::size_t numbers = 0;
            std::size_t cells = 0;
            for (std::size_t i = lines_.size() > 1 ? 1 : 0; i < lines_.size(); ++i) {
                const auto row = cellsOf(lines_[i], candidate);
                alike += row.size() == count ? 1 : 0;
                cells += row.size();
                numbers +=
                    static_cast<std::size_t>(std::count_if(row.begin(), row.end(), [](std::string_view cell) {
                        return cell.empty() || isNumber(cell);
                    }));
            }
            // The fraction of numbers counts twice, so that one damaged line does not change the separator.
            const double score = count < 2 || alike == 0 || cells == 0
                                     ? 0
                                     : static_cast<double>(alike) / static_cast<double>(lines_.size()) +
                                           2 * static_cast<double>(numbers) / static_cast<double>(cells);
            if (score > bestScore) {
                best = candidate;
                bestScore = score;
            }
        }
        // A comma in numbers below a single heading is a decimal separator.
        const char fallback = separatorOf(lines_.front());
        return best != kNoSeparator ? best : fallback == format_.decimal ? kNoSeparator : fallback;
    }

    void findHeader() {
        if (format_.hasHeader) {
            layout_.hasHeader = *format_.hasHeader;
            return;
        }
        if (lines_.empty()) {
            layout_.headingInComment = std::string(comment_);
            return;
        }
        const auto first = cellsOf(lines_.front(), layout_.separator);
        std::vector<bool> isText(first.size());
        bool hasNumber = false;
        for (std::size_t i = 0; i < first.size(); ++i) {
            isText[i] = !first[i].empty() && !isNumber(first[i]);
            hasNumber = hasNumber || isNumber(first[i]);
        }
        layout_.hasHeader = !hasNumber;
        for (std::size_t line = 1; line < lines_.size() && !layout_.hasHeader; ++line) {
            const auto cells = cellsOf(lines_[line], layout_.separator);
            for (std::size_t i = 0; i < cells.size() && i < isText.size(); ++i) {
                layout_.hasHeader = layout_.hasHeader || (isText[i] && isNumber(cells[i]));
            }
        }
        if (!layout_.hasHeader) {
            const bool fits = cellsOf(comment_, layout_.separator).size() == first.size() ||
                              blankSeparated(comment_).size() == first.size();
            layout_.headingInComment = fits && first.size() > 1 ? std::string(comment_) : std::string();
        }
    }

    /// True if every line has the form "1,5", so that the comma can be a separator or a decimal comma.
    bool isCommaUnclear() const {
        return layout_.separator == ',' && !format_.separator && !format_.decimal &&
               std::all_of(lines_.begin(), lines_.end(), [](std::string_view line) {
                   return std::count(line.begin(), line.end(), ',') == 1 &&
                          line.find_first_not_of("0123456789,-+") == std::string_view::npos;
               });
    }

    const QString& path_;
    const TableFormat& format_;
    std::vector<std::string_view> lines_;
    std::string_view comment_;
    TextLayout layout_;
};

class CsvParser {
public:
    CsvParser(const QString& path, const TableFormat& format) : format_(format) { table_.path = path; }

    Result<std::unique_ptr<Recording>> parse(QFile& file) {
        table_.format = QStringLiteral("CSV");
        std::string rest;
        bool isFirst = true;
        while (!file.atEnd()) {
            const QByteArray part = file.read(kReadAtOnce);
            if (part.isEmpty()) {
                break;
            }
            rest.append(part.constData(), static_cast<std::size_t>(part.size()));
            if (isFirst) {
                isFirst = false;
                constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
                rest.erase(0, rest.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
                auto layout = LayoutFinder(rest, table_.path, format_).run();
                if (!layout) {
                    return layout.error();
                }
                layout_ = *std::move(layout);
                if (!layout_.headingInComment.empty()) {
                    takeHeading(layout_.headingInComment);
                }
            }
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
        if (rows_ == 0 && contentLines_ > (isHeaded_ ? 1u : 0u)) {
            return failure(QStringLiteral("the file contains no numbers below the header"));
        }
        if (const Result<void> finished = finish(); !finished) {
            // A first line without rows is a table only if it contains the time column of a recording.
            return rows_ == 0 ? failure(QStringLiteral("the file is not a table of numbers"))
                              : finished.error();
        }
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

    bool toNumber(std::string_view cell, double& value) {
        const std::size_t column = row_.size();
        if (column < dates_.size() && dates_[column] != DateKind::None) {
            value = kNone;
            return cell.empty() || parseDate(cell, value, dates_[column]);
        }
        if (numberOf(cell, layout_.decimal, value)) {
            return true;
        }
        // The first row decides whether a column contains dates.
        return rows_ == 0 && column < dates_.size() && parseDate(cell, value, dates_[column]);
    }

    void takeLine(std::string_view line) {
        ++number_;
        line = withoutLineEnd(line);
        // Text files contain no control characters. Only the first lines are checked.
        if (rows_ == 0 && hasControlCharacters(line)) {
            isBinary_ = true;
            return;
        }
        const bool isSeparatorLine = line.size() == 5 && line.starts_with("sep=") && table_.columns.empty();
        if (isComment(line) && rows_ == 0) {
            takeCsvHeadLine(line, head_);
        }
        if (isComment(line) || withoutBlanks(line).empty() || isSeparatorLine) {
            return;
        }
        if (table_.columns.empty() && layout_.hasHeader) {
            takeHeading(line);
            return;
        }
        if (table_.columns.empty()) {
            nameColumns(cellsOf(line, layout_.separator).size());
        }
        ++contentLines_;
        row_.clear();
        std::size_t numbers = 0;
        wrong_.clear();
        const auto takeCell = [&](std::string_view cell) {
            double value = kNone;
            if (toNumber(cell, value)) {
                numbers += cell.empty() ? 0 : 1;
            } else {
                wrong_.push_back(row_.size());
                value = kNone;
            }
            row_.push_back(value);
        };
        if (layout_.separator == kBlanks || layout_.separator == kNoSeparator) {
            std::ranges::for_each(cellsOf(line, layout_.separator), takeCell);
        } else {
            splitLine(line, layout_.separator, takeCell);
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

    void nameColumns(std::size_t count) {
        for (std::size_t i = table_.columns.size(); i < count; ++i) {
            table_.columns.push_back({"column " + std::to_string(i + 1), {}, false});
        }
        table_.values.resize(table_.columns.size());
        notNumbers_.resize(table_.columns.size());
        dates_.resize(table_.columns.size());
    }

    void takeHeading(std::string_view line) {
        auto cells = cellsOf(line, layout_.separator);
        // A comment may separate its names by blanks although the numbers have another separator.
        if (!layout_.headingInComment.empty() && cells.size() < 2) {
            cells = blankSeparated(line);
        }
        for (const std::string_view cell : cells) {
            table_.columns.push_back(columnFrom(cell));
            if (cell.empty()) {
                table_.columns.back().name = "column " + std::to_string(table_.columns.size());
            }
        }
        nameColumns(cells.size());
    }

    void takeUnits(std::string_view line) {
        isHeaded_ = true;
        std::size_t column = 0;
        for (const std::string_view cell : cellsOf(line, layout_.separator)) {
            if (column < table_.columns.size()) {
                table_.columns[column++].unit = cell == "-" ? std::string() : utf8(cell);
            }
        }
    }

    void takeHead() {
        const auto units = cellsOf(head_.units, layout_.separator);
        for (std::size_t i = 0; units.size() == table_.columns.size() && i < units.size(); ++i) {
            if (table_.columns[i].unit.empty() && units[i] != "-") {
                table_.columns[i].unit = utf8(units[i]);
            }
        }
        table_.facts = std::move(head_.facts);
        table_.startUtcNs = head_.startUtcNs;
    }

    Result<void> finish() {
        takeHead();
        const TimeSource source{
            table_.columns, dates_,
            [this](std::size_t column) -> Result<std::vector<double>> { return table_.values[column]; }};
        const auto axis = chooseTimeAxis(table_.path, source, format_);
        if (!axis) {
            return axis.error();
        }
        table_.axis = *axis;
        if (axis->column && table_.columns[*axis->column].unit.empty()) {
            table_.columns[*axis->column].unit = axis->factor == 1      ? "s"
                                                 : axis->factor == 1e-3 ? "ms"
                                                 : axis->factor == 1e-6 ? "us"
                                                                        : "ns";
        }
        for (std::size_t i = 0; i < table_.columns.size(); ++i) {
            addKnowledge(table_.columns[i]);
            if (dates_[i] != DateKind::None) {
                table_.columns[i].unit = "s";
            }
            if (notNumbers_[i] > 0) {
                problem(QStringLiteral("Column \"%1\": %2 cells are not numbers.")
                            .arg(QString::fromStdString(table_.columns[i].name))
                            .arg(notNumbers_[i]));
            }
        }
        if (unsaid_ > 0) {
            table_.problems << QStringLiteral("There are %1 more problems of this kind.").arg(unsaid_);
        }
        return {};
    }

    RecordedTable table_;
    const TableFormat& format_;
    TextLayout layout_;
    CsvHead head_;
    std::size_t number_ = 0;        ///< line number
    std::size_t contentLines_ = 0;  ///< without the header and comments
    std::size_t rows_ = 0;
    bool isHeaded_ = false;  ///< true after the line of units
    bool isBinary_ = false;
    std::vector<double> row_;
    std::vector<std::size_t> wrong_;
    std::vector<std::size_t> notNumbers_;
    std::vector<DateKind> dates_;
    std::size_t unsaid_ = 0;
};

}  // namespace

Result<std::unique_ptr<Recording>> openCsv(const Text& path, const TableFormat& format) {
    QFile file;
    if (const Result<void> opened = openForReading(file, path); !opened) {
        return opened.error();
    }
    return CsvParser(path, format).parse(file);
}

}  // namespace tiller::recording
