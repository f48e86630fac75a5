// SPDX-License-Identifier: MIT
#include "robot/station/history/derived_signal.h"

#include <muParser.h>

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

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

/// An expression evaluated for each sample.
class Expression : public DerivedSignal {
public:
    /// Returns the error message; empty without an error.
    QString read(const Plain& plain, const std::function<bool(const QString&)>& exists) {
        try {
            parser_.DefineNameChars("0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.");
            parser_.DefineFun("norm", normOf);
            parser_.DefineConst("pi", 3.14159265358979323846);
            parser_.DefineConst("e", 2.71828182845904523536);
            parser_.SetExpr(plain.expression.toStdString());
            QStringList words;
            for (const auto& [name, unused] : parser_.GetUsedVar()) {
                words.append(fromParser(name));
                const QString key = plain.nameOf(words.back());
                if (!exists(key)) {
                    return DerivationText::tr(
                               "The signal “%1” does not exist. See the signal list for the names.")
                        .arg(key);
                }
                inputs_.append(key);
            }
            if (inputs_.isEmpty() || inputs_.size() > kMaxInputs) {
                return inputs_.isEmpty()
                           ? DerivationText::tr(
                                 "The expression contains no signal. Add the name of a signal.")
                           : DerivationText::tr(
                                 "The expression contains too many signals. Use fewer signals.");
            }
            values_.resize(static_cast<std::size_t>(inputs_.size()));
            for (qsizetype i = 0; i < inputs_.size(); ++i) {
                parser_.DefineVar(words[i].toStdString(), &values_[static_cast<std::size_t>(i)]);
            }
            parser_.Eval();
            if (parser_.GetNumResults() != 1) {
                return DerivationText::tr("The expression must evaluate to one number.");
            }
        } catch (const mu::Parser::exception_type& error) {
            return plain.inNames(fromParser(error.GetMsg()));
        }
        return {};
    }

    double valueAt(const SeriesBuffer& history, const std::vector<int>& columns,
                   std::int64_t sample) override {
        for (std::size_t i = 0; i < values_.size(); ++i) {
            values_[i] = history.value(columns[i], sample);
            if (std::isnan(values_[i])) {
                return kNoResult;
            }
        }
        try {
            const double result = parser_.Eval();
            return std::isfinite(result) ? result : kNoResult;
        } catch (const mu::Parser::exception_type&) {
            return kNoResult;  // some muParser versions throw on division by zero
        }
    }

private:
    mu::Parser parser_;
    std::vector<double> values_;
};

/// A value computed over a time window that ends with the sample.
class Stretch : public DerivedSignal {
public:
    Stretch(const QString& input, double seconds, bool mean) : seconds_(seconds), mean_(mean) {
        inputs_ = {input};
    }

    double lookBack() const override { return seconds_; }

    double valueAt(const SeriesBuffer& history, const std::vector<int>& columns,
                   std::int64_t sample) override {
        const double value = history.value(columns[0], sample);
        // Samples are not consecutive, so restart the window.
        if (sample != next_ || history.gapBefore(sample) || std::isnan(value)) {
            points_.clear();
            sum_ = 0;
        }
        next_ = sample + 1;
        if (std::isnan(value)) {
            return kNoResult;
        }
        points_.push_back({history.time(sample), value});
        sum_ += value;
        const double since = points_.back().time - seconds_ * (1 + 1e-9);
        // The rate of change also needs the last point before the window. The mean needs only points within
        // it.
        while (points_.size() > 2 && (mean_ ? points_.front().time : points_[1].time) < since) {
            sum_ -= points_.front().value;
            points_.pop_front();
        }
        if (mean_) {
            if (sample % kSumAgainEvery == 0) {
                sum_ = 0;
                for (const Point& point : points_) {
                    sum_ += point.value;
                }
            }
            return sum_ / static_cast<double>(points_.size());
        }
        const double span = points_.back().time - points_.front().time;
        return span > 0 ? (points_.back().value - points_.front().value) / span : kNoResult;
    }

private:
    static constexpr std::int64_t kSumAgainEvery = 4096;  // bounds the accumulated rounding error

    struct Point {
        double time, value;
    };
    double seconds_;
    bool mean_;
    std::deque<Point> points_;
    double sum_ = 0;
    std::int64_t next_ = -1;
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
    static const QRegularExpression kStretch(
        QStringLiteral("^(deriv|mean)\\(\\s*([A-Za-z_][\\w.]*)\\s*,\\s*([0-9.]+)\\s*\\)$"));
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
    // The parser would interpret "=" as an assignment to the signal.
    static const QRegularExpression kAssigns(QStringLiteral("(?<![=<>!])=(?!=)"));
    const Plain plain(expression);
    if (plain.expression.contains(kAssigns)) {
        return wrong(DerivationText::tr("Too many equals signs. Use == to compare values."));
    }
    std::shared_ptr<DerivedSignal> made;
    if (const QRegularExpressionMatch stretch = kStretch.match(plain.expression); stretch.hasMatch()) {
        bool isNumber = false;
        const double seconds = stretch.captured(3).toDouble(&isNumber);
        const QString input = plain.nameOf(stretch.captured(2));
        if (!exists(input)) {
            return wrong(
                DerivationText::tr("The signal “%1” does not exist. See the signal list for the names.")
                    .arg(input));
        }
        if (!isNumber || seconds < kShortestStretch || seconds > kMaxStretch) {
            return wrong(DerivationText::tr("The time window must be between 0.001 and 60 seconds."));
        }
        made = std::make_shared<Stretch>(input, seconds, stretch.captured(1) == QLatin1String("mean"));
    } else {
        auto parsed = std::make_shared<Expression>();
        if (const QString problem = parsed->read(plain, exists); !problem.isEmpty()) {
            return wrong(problem);
        }
        made = parsed;
    }
    made->name_ = form.captured(1).trimmed();
    made->unit_ = form.captured(2).trimmed();
    made->text_ = made->unit_.isEmpty()
                      ? QStringLiteral("%1 = %2").arg(made->name_, expression)
                      : QStringLiteral("%1 [%2] = %3").arg(made->name_, made->unit_, expression);
    // The normalized text must also be valid input, so it has the same length limit.
    return made->text_.size() > kMaxTextLength ? Result<std::shared_ptr<DerivedSignal>>(tooLong())
                                               : Result<std::shared_ptr<DerivedSignal>>(made);
}

}  // namespace tiller
