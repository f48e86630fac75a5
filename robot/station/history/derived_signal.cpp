// SPDX-License-Identifier: MIT
#include "robot/station/history/derived_signal.h"

#include <muParser.h>

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace tiller {

namespace {

/// Translation context of this file for lupdate.
struct DerivationText {
    Q_DECLARE_TR_FUNCTIONS(DerivedSignal)
};

constexpr double kNoResult = std::numeric_limits<double>::quiet_NaN();
constexpr double kShortestStretch = 0.001;  // [s]
constexpr double kMaxStretch = 60;

Error wrong(const QString& why) {
    return {ErrorCode::InvalidArgument, DerivationText::tr("compute a signal"), why};
}

double normOf(const double* values, int count) {
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        sum += values[i] * values[i];
    }
    return std::sqrt(sum);
}

QString fromParser(const mu::string_type& text) {
    return QString::fromStdString(text);
}

/// An expression in which names in braces are replaced by identifiers that the parser accepts.
struct Plain {
    QString expression;
    QStringList braced;  ///< names in braces, in order of first appearance

    explicit Plain(const QString& text) {
        static const QRegularExpression kBraced(QStringLiteral("\\{([^{}]+)\\}"));
        qsizetype done = 0;
        for (auto found = kBraced.globalMatch(text); found.hasNext();) {
            const QRegularExpressionMatch match = found.next();
            const qsizetype known = braced.indexOf(match.captured(1));
            if (known < 0) {
                braced.append(match.captured(1));
            }
            // Spaces keep an adjacent name from merging with the identifier.
            expression += text.mid(done, match.capturedStart() - done) + QLatin1Char(' ') +
                          word(known < 0 ? braced.size() - 1 : known) + QLatin1Char(' ');
            done = match.capturedEnd();
        }
        expression += text.mid(done);
    }
    /// Returns the original name of an identifier in the expression.
    QString nameOf(const QString& given) const {
        for (qsizetype i = 0; i < braced.size(); ++i) {
            if (given == word(i)) {
                return braced[i];
            }
        }
        return given;
    }
    /// Replaces the identifiers in a parser message by the original names.
    QString inNames(QString words) const {
        for (qsizetype i = braced.size(); i-- > 0;) {
            words.replace(word(i), braced[i]);
        }
        return words;
    }

private:
    static QString word(qsizetype number) { return QStringLiteral("braced_%1_").arg(number); }
};

/// A part of an expression. Its values are requested sample by sample.
class Node {
public:
    virtual ~Node() = default;
    virtual double lookBack() const = 0;
    virtual double valueAt(const SeriesBuffer& history, const std::vector<int>& columns,
                           std::int64_t sample) = 0;
};

/// A function of the values up to a sample, such as a filter. Gaps and missing values reset its state.
class Running : public Node {
public:
    Running(std::unique_ptr<Node> input, double lookBack) : input_(std::move(input)), lookBack_(lookBack) {}

    double lookBack() const override { return lookBack_ + input_->lookBack(); }
    double valueAt(const SeriesBuffer& history, const std::vector<int>& columns,
                   std::int64_t sample) override {
        const double value = input_->valueAt(history, columns, sample);
        if (sample != next_ || history.gapBefore(sample) || std::isnan(value)) {
            restart();
        }
        next_ = sample + 1;
        return std::isnan(value) ? kNoResult : add(history.time(sample), value);
    }

protected:
    virtual void restart() = 0;
    virtual double add(double time, double value) = 0;

private:
    std::unique_ptr<Node> input_;
    double lookBack_;
    std::int64_t next_ = -1;
};

struct Point {
    double time, value;
};

double areaBetween(const Point& from, const Point& to) {
    return (to.time - from.time) * (from.value + to.value) / 2;
}

/// A value computed over a time window that ends with the sample.
class Stretch : public Running {
public:
    enum class Kind { Derivative, Mean, Median, Integral };

    Stretch(std::unique_ptr<Node> input, Kind kind, double seconds)
        : Running(std::move(input), seconds), kind_(kind), seconds_(seconds) {}

protected:
    void restart() override {
        points_.clear();
        sorted_.clear();
        sum_ = 0;
    }

    double add(double time, double value) override {
        if (kind_ == Kind::Integral && !points_.empty()) {
            sum_ += areaBetween(points_.back(), {time, value});
        }
        sum_ += kind_ == Kind::Mean ? value : 0;
        points_.push_back({time, value});
        if (kind_ == Kind::Median) {
            sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), value), value);
        }
        // The rate of change starts at the last point at or before the start of the window. The other functions
        // need only points within the window.
        const double rounding = seconds_ * 1e-6;
        const double start = time - seconds_;
        while (kind_ == Kind::Derivative ? points_.size() > 2 && points_[1].time <= start + rounding
                                         : points_.size() > 1 && points_.front().time < start - rounding) {
            removeFirst();
        }
        if (++added_ % kSumAgainEvery == 0) {
            sumAgain();
        }
        return result();
    }

private:
    static constexpr std::int64_t kSumAgainEvery = 4096;  // bounds the accumulated rounding error

    void removeFirst() {
        const Point first = points_.front();
        points_.pop_front();
        sum_ -= kind_ == Kind::Mean       ? first.value
                : kind_ == Kind::Integral ? areaBetween(first, points_.front())
                                          : 0;
        if (kind_ == Kind::Median) {
            sorted_.erase(std::lower_bound(sorted_.begin(), sorted_.end(), first.value));
        }
    }

    void sumAgain() {
        sum_ = 0;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            sum_ += kind_ == Kind::Mean                ? points_[i].value
                    : kind_ == Kind::Integral && i > 0 ? areaBetween(points_[i - 1], points_[i])
                                                       : 0;
        }
    }

    double result() const {
        const std::size_t middle = sorted_.size() / 2;
        switch (kind_) {
            case Kind::Mean:
                return sum_ / static_cast<double>(points_.size());
            case Kind::Median:
                return sorted_.size() % 2 == 1 ? sorted_[middle]
                                               : (sorted_[middle - 1] + sorted_[middle]) / 2;
            case Kind::Integral:
                return sum_;
            case Kind::Derivative:
                break;
        }
        const double span = points_.back().time - points_.front().time;
        return span > 0 ? (points_.back().value - points_.front().value) / span : kNoResult;
    }

    Kind kind_;
    double seconds_;
    std::deque<Point> points_;
    std::vector<double> sorted_;  ///< values in the window; only for the median
    double sum_ = 0;
    std::int64_t added_ = 0;
};

/// A Butterworth filter, as a cascade of sections of first and second order. Each step applies the bilinear
/// transform with the time since the last sample and a cut-off frequency that is pre-warped for this time.
/// For a constant sample rate, this is the standard digital filter.
class Butterworth : public Running {
public:
    enum class Band { Low, High };

    Butterworth(std::unique_ptr<Node> input, Band band, double hertz, int order)
        : Running(std::move(input), settlingTime(hertz, order)), band_(band), hertz_(hertz) {
        for (int i = 0; i < order / 2; ++i) {
            sections_.push_back({std::sin(kPi * (2 * i + 1) / (2 * order)), false});
        }
        if (order % 2 == 1) {
            sections_.push_back({0, true});
        }
    }

    /// Time after which earlier values no longer affect the output, except for rounding errors [s].
    static double settlingTime(double hertz, int order) {
        constexpr double kTimeConstants = 30;
        return kTimeConstants / (2 * kPi * hertz * std::sin(kPi / (2 * order)));
    }

protected:
    void restart() override { hasLast_ = false; }

    double add(double time, double value) override {
        if (!hasLast_) {
            // Start as if the input had always had its first value.
            hasLast_ = true;
            lastTime_ = time;
            double input = value;
            for (Section& section : sections_) {
                section.position = section.input = input;
                section.speed = 0;
                input = band_ == Band::Low ? input : 0;
            }
            return input;
        }
        const double step = time - lastTime_;
        lastTime_ = time;
        // A frequency of half the sample rate or above cannot be filtered.
        if (!(step > 0) || hertz_ * step >= 0.5) {
            hasLast_ = false;
            return kNoResult;
        }
        // Pre-warped cut-off frequency, per half step.
        const double rate = std::tan(kPi * hertz_ * step);
        double input = value;
        for (Section& section : sections_) {
            input = section.isFirstOrder ? first(section, input, rate) : second(section, input, rate);
        }
        return input;
    }

private:
    static constexpr double kPi = 3.14159265358979323846;

    struct Section {
        double damping;
        bool isFirstOrder;
        double position = 0;  ///< output of the low-pass filter
        double speed = 0;     ///< derivative of `position`, divided by the cut-off frequency
        double input = 0;
    };

    double first(Section& section, double input, double rate) const {
        section.position += rate * (input + section.input - 2 * section.position) / (1 + rate);
        section.input = input;
        return band_ == Band::Low ? section.position : input - section.position;
    }

    /// Solves position' = speed and speed' = input - position - 2 damping speed by the trapezoidal rule.
    double second(Section& section, double input, double rate) const {
        const double begin =
            section.speed +
            rate * (input + section.input - 2 * section.position - 2 * section.damping * section.speed) -
            rate * rate * section.speed;
        const double speed = begin / (1 + 2 * section.damping * rate + rate * rate);
        section.position += rate * (section.speed + speed);
        section.speed = speed;
        section.input = input;
        return band_ == Band::Low ? section.position
                                  : input - section.position - 2 * section.damping * section.speed;
    }

    Band band_;
    double hertz_;
    std::vector<Section> sections_;
    double lastTime_ = 0;
    bool hasLast_ = false;
};

/// An expression of the parser, evaluated for each sample. Calls of running functions are variables of the
/// expression.
class Expression : public Node {
public:
    double lookBack() const override {
        double longest = 0;
        for (const Variable& variable : variables_) {
            longest = std::max(longest, variable.node ? variable.node->lookBack() : 0);
        }
        return longest;
    }

    double valueAt(const SeriesBuffer& history, const std::vector<int>& columns,
                   std::int64_t sample) override {
        bool isComplete = true;
        // Running functions need every sample, even if another value is missing.
        for (std::size_t i = 0; i < variables_.size(); ++i) {
            const Variable& variable = variables_[i];
            values_[i] = variable.node ? variable.node->valueAt(history, columns, sample)
                                       : history.value(columns[variable.input], sample);
            isComplete = isComplete && !std::isnan(values_[i]);
        }
        if (!isComplete) {
            return kNoResult;
        }
        try {
            const double result = parser_.Eval();
            // The history stores floats, so a larger result would become infinite.
            return std::abs(result) <= std::numeric_limits<float>::max() ? result : kNoResult;
        } catch (const mu::Parser::exception_type&) {
            return kNoResult;  // some muParser versions throw on division by zero
        }
    }

private:
    friend class ExpressionReader;
    struct Variable {
        std::size_t input = 0;         ///< index in the inputs of the signal
        std::unique_ptr<Node> node{};  ///< running function used instead of an input; null for an input
    };
    mu::Parser parser_;
    std::vector<Variable> variables_;
    std::vector<double> values_;
};

/// Matches a number with a decimal comma. The parser would read two values. In lists, a space after the comma
/// avoids the ambiguity.
const QRegularExpression& decimalComma() {
    static const QRegularExpression kPattern(QStringLiteral("(?<![\\w.])\\d+,\\d+"));
    return kPattern;
}

QString decimalCommaText(const QString& number) {
    return DerivationText::tr("“%1” contains a decimal comma. Write decimal numbers with a point: %2")
        .arg(number, QString(number).replace(QLatin1Char(','), QLatin1Char('.')));
}

/// Reads an expression with calls of running functions, which may contain expressions.
class ExpressionReader {
public:
    ExpressionReader(const Plain& plain, const std::function<bool(const QString&)>& exists)
        : plain_(plain), exists_(exists) {}

    /// Returns null after an error.
    std::unique_ptr<Node> read(const QString& text, int depth = 0) {
        if (depth > DerivedSignal::kMaxNesting) {
            return fail(DerivationText::tr("The functions are nested too deeply. Use at most %1 levels.")
                            .arg(DerivedSignal::kMaxNesting));
        }
        static const QRegularExpression kCall(
            QStringLiteral("(?<![\\w.])(deriv|mean|median|integral|lowpass|highpass)\\s*\\("));
        std::vector<std::unique_ptr<Node>> calls;
        QString expression;
        qsizetype done = 0;
        for (auto call = kCall.match(text); call.hasMatch(); call = kCall.match(text, done)) {
            const std::optional<QStringList> arguments = argumentsFrom(text, call.capturedEnd());
            if (!arguments) {
                return fail(
                    DerivationText::tr("The closing parenthesis of “%1” is missing.").arg(call.captured(1)));
            }
            expression += text.mid(done, call.capturedStart() - done) + wordOf(calls.size());
            done = call.capturedEnd() + arguments->join(QLatin1Char(',')).size() + 1;
            calls.push_back(readCall(call.captured(1), *arguments, depth));
            if (!calls.back()) {
                return nullptr;
            }
        }
        return readPlain(expression + text.mid(done), std::move(calls));
    }

    const QStringList& inputs() const { return inputs_; }
    const QString& problem() const { return problem_; }

private:
    static QString wordOf(std::size_t call) { return QStringLiteral(" running_%1_ ").arg(call); }

    std::nullptr_t fail(const QString& problem) {
        problem_ = problem;
        return nullptr;
    }

    /// The arguments up to the closing parenthesis; empty if the parenthesis is missing.
    static std::optional<QStringList> argumentsFrom(const QString& text, qsizetype begin) {
        QStringList arguments(QString{});
        int open = 0;
        for (qsizetype i = begin; i < text.size(); ++i) {
            const QChar each = text[i];
            if (each == QLatin1Char(')') && open-- == 0) {
                return arguments;
            }
            open += each == QLatin1Char('(') ? 1 : 0;
            if (each == QLatin1Char(',') && open == 0) {
                arguments << QString();
            } else {
                arguments.back() += each;
            }
        }
        return std::nullopt;
    }

    std::unique_ptr<Node> readCall(const QString& name, const QStringList& arguments, int depth) {
        const bool isFilter = name.endsWith(QLatin1String("pass"));
        bool areNumbers = arguments.size() == 2 || (isFilter && arguments.size() == 3);
        bool isNumber = false;
        const double number = arguments.value(1).toDouble(&isNumber);
        constexpr int kDefaultOrder = 2;
        constexpr int kMaxOrder = 8;
        bool isOrder = true;
        const int order = arguments.size() == 3 ? arguments[2].toInt(&isOrder) : kDefaultOrder;
        areNumbers =
            areNumbers && isNumber && isOrder && std::isfinite(number) && order >= 1 && order <= kMaxOrder;
        const QRegularExpressionMatch comma = decimalComma().match(arguments.join(QLatin1Char(',')));
        if (!areNumbers && comma.hasMatch()) {
            return fail(decimalCommaText(comma.captured()));
        }
        if (!areNumbers) {
            return fail(
                isFilter
                    ? DerivationText::tr("“%1” needs a signal or an expression, a cut-off frequency in Hz "
                                         "and optionally the order (1 to 8), for example "
                                         "%1(actual_q_0, 10, 2).")
                          .arg(name)
                    : DerivationText::tr("“%1” needs a signal or an expression and a time window in "
                                         "seconds, for example %1(actual_q_0, 0.5).")
                          .arg(name));
        }
        if (isFilter) {
            constexpr double kMaxFrequency = 10'000;
            const double lowest = Butterworth::settlingTime(1, order) / kMaxStretch;
            if (number < lowest || number > kMaxFrequency) {
                return fail(DerivationText::tr("The cut-off frequency of “%1” must be between %2 and %3 Hz.")
                                .arg(name)
                                .arg(std::ceil(lowest * 100) / 100)
                                .arg(kMaxFrequency));
            }
        } else if (number < kShortestStretch || number > kMaxStretch) {
            return fail(DerivationText::tr("The time window of “%1” must be between 0.001 and 60 seconds.")
                            .arg(name));
        }
        std::unique_ptr<Node> input = read(arguments.front(), depth + 1);
        if (!input) {
            return nullptr;
        }
        if (isFilter) {
            return std::make_unique<Butterworth>(
                std::move(input),
                name == QLatin1String("lowpass") ? Butterworth::Band::Low : Butterworth::Band::High, number,
                order);
        }
        const Stretch::Kind kind = name == QLatin1String("deriv")    ? Stretch::Kind::Derivative
                                   : name == QLatin1String("mean")   ? Stretch::Kind::Mean
                                   : name == QLatin1String("median") ? Stretch::Kind::Median
                                                                     : Stretch::Kind::Integral;
        return std::make_unique<Stretch>(std::move(input), kind, number);
    }

    std::unique_ptr<Node> readPlain(const QString& text, std::vector<std::unique_ptr<Node>> calls) {
        if (const QRegularExpressionMatch comma = decimalComma().match(text); comma.hasMatch()) {
            return fail(decimalCommaText(comma.captured()));
        }
        auto made = std::make_unique<Expression>();
        mu::Parser& parser = made->parser_;
        try {
            parser.DefineNameChars("0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.");
            parser.DefineFun("norm", normOf);
            parser.DefineConst("pi", 3.14159265358979323846);
            parser.DefineConst("e", 2.71828182845904523536);
            // Check function names first, because the parser would report the parenthesis instead of the
            // name.
            static const QRegularExpression kFunction(QStringLiteral("(?<![\\w.])([A-Za-z_][\\w.]*)\\s*\\("));
            for (auto found = kFunction.globalMatch(text); found.hasNext();) {
                const QString name = found.next().captured(1);
                if (!parser.GetFunDef().contains(name.toStdString())) {
                    return fail(
                        DerivationText::tr("The function “%1” does not exist.").arg(plain_.nameOf(name)));
                }
            }
            parser.SetExpr(text.toStdString());
            std::vector<std::string> words;
            for (const auto& [name, unused] : parser.GetUsedVar()) {
                const QString word = fromParser(name);
                words.push_back(name);
                Expression::Variable& variable = made->variables_.emplace_back();
                for (std::size_t i = 0; i < calls.size(); ++i) {
                    if (word == wordOf(i).trimmed()) {
                        variable.node = std::move(calls[i]);
                    }
                }
                if (!variable.node && !takeInput(plain_.nameOf(word), variable.input)) {
                    return nullptr;
                }
            }
            if (made->variables_.empty()) {
                return fail(
                    DerivationText::tr("The expression contains no signal. Add the name of a signal."));
            }
            made->values_.resize(made->variables_.size());
            for (std::size_t i = 0; i < words.size(); ++i) {
                parser.DefineVar(words[i], &made->values_[i]);
            }
            parser.Eval();
            if (parser.GetNumResults() != 1) {
                return fail(DerivationText::tr("The expression must evaluate to one number."));
            }
        } catch (const mu::Parser::exception_type& error) {
            return fail(plain_.inNames(fromParser(error.GetMsg())));
        }
        return made;
    }

    bool takeInput(const QString& key, std::size_t& index) {
        if (!exists_(key)) {
            fail(DerivationText::tr("The signal “%1” does not exist. See the signal list for the names.")
                     .arg(key));
            return false;
        }
        qsizetype known = inputs_.indexOf(key);
        if (known < 0) {
            known = inputs_.size();
            inputs_.append(key);
        }
        if (inputs_.size() > DerivedSignal::kMaxInputs) {
            fail(DerivationText::tr("The expression contains too many signals. Use fewer signals."));
            return false;
        }
        index = static_cast<std::size_t>(known);
        return true;
    }

    const Plain& plain_;
    const std::function<bool(const QString&)>& exists_;
    QStringList inputs_;
    QString problem_;
};

class ComputedSignal : public DerivedSignal {
public:
    ComputedSignal(std::unique_ptr<Node> root, const QStringList& inputs) : root_(std::move(root)) {
        inputs_ = inputs;
    }
    double lookBack() const override { return root_->lookBack(); }
    double valueAt(const SeriesBuffer& history, const std::vector<int>& columns,
                   std::int64_t sample) override {
        return root_->valueAt(history, columns, sample);
    }

private:
    std::unique_ptr<Node> root_;
};

}  // namespace

QString DerivedSignal::written(const QString& key) {
    static const QRegularExpression kPlain(QStringLiteral("^[A-Za-z_][\\w.]*$"));
    return kPlain.match(key).hasMatch() ? key : QStringLiteral("{%1}").arg(key);
}

Result<std::shared_ptr<DerivedSignal>> DerivedSignal::make(
    const QString& text, const std::function<bool(const QString&)>& exists) {
    static const QRegularExpression kForm(
        QStringLiteral("^\\s*([^=\\[\\]]{1,40}?)\\s*(?:\\[([^\\[\\]=]{0,12})\\])?\\s*=\\s*([^=].*)$"),
        QRegularExpression::DotMatchesEverythingOption);
    const auto tooLong = [] {
        return wrong(DerivationText::tr("The text is too long. Use a shorter name or expression."));
    };
    if (text.size() > kMaxTextLength) {
        return tooLong();
    }
    const QRegularExpressionMatch form = kForm.match(text);
    if (!form.hasMatch()) {
        return wrong(
            DerivationText::tr("Enter a name, an equals sign and an expression, for example |F| [N] = "
                               "norm(actual_TCP_force_0, actual_TCP_force_1)"));
    }
    const QString expression = form.captured(3).trimmed();
    // Refuse "=", which the parser would interpret as an assignment to the signal.
    static const QRegularExpression kAssigns(QStringLiteral("(?<![=<>!])=(?!=)"));
    const Plain plain(expression);
    if (plain.expression.contains(kAssigns)) {
        return wrong(DerivationText::tr("Too many equals signs. Use == to compare values."));
    }
    ExpressionReader reader(plain, exists);
    std::unique_ptr<Node> root = reader.read(plain.expression);
    if (!root) {
        return wrong(reader.problem());
    }
    const auto made = std::make_shared<ComputedSignal>(std::move(root), reader.inputs());
    made->name_ = form.captured(1).trimmed();
    made->unit_ = form.captured(2).trimmed();
    made->text_ = made->unit_.isEmpty()
                      ? QStringLiteral("%1 = %2").arg(made->name_, expression)
                      : QStringLiteral("%1 [%2] = %3").arg(made->name_, made->unit_, expression);
    // The normalized text must also be valid input, so it has the same length limit.
    return made->text_.size() > kMaxTextLength
               ? Result<std::shared_ptr<DerivedSignal>>(tooLong())
               : Result<std::shared_ptr<DerivedSignal>>(std::shared_ptr<DerivedSignal>(made));
}

}  // namespace tiller
