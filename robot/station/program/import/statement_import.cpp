// SPDX-License-Identifier: MIT
#include "robot/station/program/import/statement_import.h"

#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/simulator/script_run.h"
#include "robot/station/program/expression.h"
#include "robot/station/program/import/script_statements.h"
#include "robot/station/program/import/variable_types.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/program_script.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {

using project::ProgramStep;

namespace {

using Kind = ScriptStatement::Kind;
using Statements = std::vector<ScriptStatement>;
using Row = ImportRow;

constexpr int kMaxPasses = 50;
constexpr double kSameTcp = 1e-9;  ///< [m, rad]

const QString kNoStep = QStringLiteral("no step generates this statement");

QString idOf(const QUuid& id) {
    return id.toString(QUuid::WithoutBraces);
}

ProgramStep makeStep(const char* kind, const QJsonObject& fields = {}) {
    ProgramStep step = newStep(*findStepKind(QLatin1String(kind)));
    for (auto field = fields.begin(); field != fields.end(); ++field) {
        step.fields.insert(field.key(), field.value());
    }
    return step;
}

bool isSame(const Pose& a, const Pose& b) {
    return (a.position - b.position).norm() < kSameTcp && (a.rotation - b.rotation).norm() < kSameTcp;
}

/// True if the expression in a step gives the same script.
bool isExpression(const QString& text) {
    const Expression parsed = parseExpression(text);
    return parsed.error.isEmpty() && parsed.script == text.trimmed();
}

QString poseText(const Pose& pose) {
    QStringList numbers;
    for (const double number : pose.array()) {
        numbers << QString::number(number);
    }
    return QStringLiteral("p[%1]").arg(numbers.join(QStringLiteral(", ")));
}

std::optional<bool> flagLiteral(const QString& text) {
    return text == QLatin1String("True") || text == QLatin1String("true")     ? std::optional(true)
           : text == QLatin1String("False") || text == QLatin1String("false") ? std::optional(false)
                                                                              : std::nullopt;
}

std::optional<int> wholeLiteral(const QString& text) {
    bool ok = false;
    const int value = text.toInt(&ok);
    return ok ? std::optional(value) : std::nullopt;
}

/// A string literal that a step writes unchanged.
std::optional<QString> plainString(const QString& literal) {
    const auto text = stringLiteral(literal);
    return text && !text->isEmpty() && scriptString(*text) == literal ? text : std::nullopt;
}

/// Channel of a digital terminal in steps, from the group in the name of the script function.
std::optional<int> channelOf(const QString& group, const QString& pin) {
    const auto number = wholeLiteral(pin);
    const int count = group == QLatin1String("tool") ? 2 : 8;
    if (!number || *number < 0 || *number >= count) {
        return std::nullopt;
    }
    return *number + (group == QLatin1String("tool") ? 16 : group == QLatin1String("configurable") ? 8 : 0);
}

/// Calls `visit` for each statement, also inside of blocks.
template <class Visit>
void forEachStatement(const Statements& list, bool inFunction, const Visit& visit) {
    for (const ScriptStatement& statement : list) {
        visit(statement, inFunction);
        forEachStatement(statement.body, inFunction || statement.kind == Kind::Function, visit);
        for (const ScriptStatement::Branch& branch : statement.branches) {
            forEachStatement(branch.body, inFunction, visit);
        }
    }
}

/// True if a statement of the list, but not of a function in it, begins with this word.
bool hasWord(const Statements& list, const QString& word) {
    const QRegularExpression begin(QStringLiteral("^%1\\b").arg(word));
    bool found = false;
    forEachStatement(list, false, [&](const ScriptStatement& statement, bool inFunction) {
        found = found ||
                (!inFunction && statement.kind == Kind::Simple && begin.match(statement.code).hasMatch());
    });
    return found;
}

bool callsSetTcp(const QString& text) {
    return text.contains(QLatin1String("set_tcp"));
}

QSet<QString> wordsOf(const QString& text) {
    static const QRegularExpression word(QStringLiteral("\"[^\"\\n]*\"|#[^\\n]*|([A-Za-z_]\\w*)"));
    QSet<QString> words;
    for (auto it = word.globalMatch(text); it.hasNext();) {
        words.insert(it.next().captured(1));
    }
    return words;
}

void addWords(const std::vector<ProgramStep>& steps, QSet<QString>& words) {
    for (const ProgramStep& step : steps) {
        for (const QJsonValueConstRef field : step.fields) {
            words.unite(wordsOf(field.toString()));
        }
        addWords(step.steps, words);
    }
}

std::size_t countOf(const std::vector<ProgramStep>& steps) {
    std::size_t count = steps.size();
    for (const ProgramStep& step : steps) {
        count += countOf(step.steps);
    }
    return count;
}

class StatementImport {
public:
    StatementImport(const project::Project& project, const QString& name, const QStringList& lines)
        : before_(project), name_(name), lines_(lines) {}

    Result<ImportedProgram> run(const std::vector<simulator::pendant::NodeMark>& marks) {
        Result<Statements> split = splitScript(lines_, marks);
        if (!split) {
            const auto text = textOfDefinition();
            return text ? asText(*text, split.error().context)
                        : Result<ImportedProgram>(Error{ErrorCode::ScriptError, split.error().context, {}});
        }
        if (const QString why = findMain(std::move(*split)); !why.isEmpty()) {
            return Error{ErrorCode::ScriptError, why, {}};
        }
        if (hasWord(main_, QStringLiteral("return"))) {
            return asText(textOf(main_), QStringLiteral("the program contains a return"));
        }
        analyse();
        if (isPendant_) {
            foldInstallation();
        }
        for (int pass = 0; pass < kMaxPasses; ++pass) {
            convert();
            if (!keepReferenced()) {
                continue;
            }
            if (countOf(out_.project.programs.find(out_.program)->steps) > project::kMaxProgramSteps) {
                return asText(textOf(main_), QStringLiteral("the program has too many statements"));
            }
            const ProgramScript script = writeScript(out_.project, out_.program);
            if (script.ok()) {
                addNotes(script);
                return isCompiled(script.text)
                           ? Result<ImportedProgram>(out_)
                           : asText(textOf(main_), QStringLiteral("the steps use each other's names"));
            }
            if (!deny(script.problems)) {
                return asText(textOf(main_), script.problems.front().text);
            }
        }
        return asText(textOf(main_), QStringLiteral("the program is too complex"));
    }

private:
    struct Tcp {
        enum class Kind { Initial, Known, Unknown };
        Kind kind = Kind::Initial;
        Pose value;
    };
    struct Definition {
        QString expression;
        Tcp tcp;  ///< when the definition is executed
    };
    struct Target {
        std::optional<JointPositions> joints;
        QString name;         ///< of the variable with the position; may be empty
        QStringList defined;  ///< variables that the steps do not need
        QString pose;         ///< if there are no joint positions
    };

    // ---- the script as a whole --------------------------------------------------------------------------

    QString findMain(Statements top) {
        static const QRegularExpression def(QStringLiteral("^(?:def|sec)\\s+(\\w+)\\s*\\(\\s*\\)\\s*:$"));
        Statements comments;
        std::vector<ScriptStatement*> functions, others;
        for (ScriptStatement& statement : top) {
            if (statement.kind == Kind::Comment || statement.kind == Kind::Omitted) {
                comments.push_back(statement);
            } else {
                (statement.kind == Kind::Function ? functions : others).push_back(&statement);
            }
        }
        const auto name =
            functions.size() == 1 ? def.match(functions.front()->code) : QRegularExpressionMatch();
        if (name.hasMatch() &&
            (others.empty() || (others.size() == 1 && others.front()->code == name.captured(1) + "()"))) {
            main_ = std::move(comments);
            std::move(functions.front()->body.begin(), functions.front()->body.end(),
                      std::back_inserter(main_));
        } else if (others.empty()) {
            return functions.empty()
                       ? QStringLiteral("the file contains no statements")
                       : QStringLiteral(
                             "the file contains %1 functions or parameters, but no statement that "
                             "calls a function; add the call")
                             .arg(functions.size());
        } else {
            main_ = std::move(top);
        }
        return main_.empty() ? QStringLiteral("the program contains no statements") : QString();
    }

    /// Moves the statements before the first node into a folder.
    void foldInstallation() {
        const auto end = std::find_if(main_.begin(), main_.end(), [](const ScriptStatement& statement) {
            return statement.node > 0 || statement.kind == Kind::Function;
        });
        if (end - main_.begin() < 2) {
            return;
        }
        ScriptStatement folder;
        folder.kind = Kind::Folder;
        folder.first = main_.front().first;
        folder.last = (end - 1)->last;
        folder.code = QStringLiteral("Installation");
        folder.body.assign(std::make_move_iterator(main_.begin()), std::make_move_iterator(end));
        main_.erase(main_.begin(), end);
        main_.insert(main_.begin(), std::move(folder));
    }

    /// The lines between the first `def` and the last `end`.
    std::optional<QString> textOfDefinition() const {
        static const QRegularExpression def(QStringLiteral("^\\s*def\\s+\\w+\\s*\\(\\s*\\)\\s*:\\s*$"));
        const qsizetype first = lines_.indexOf(def);
        const qsizetype last = lines_.lastIndexOf(QRegularExpression(QStringLiteral("^\\s*end\\s*$")));
        const QString text =
            first < 0 || last <= first ? QString() : lines_.mid(first + 1, last - first - 1).join('\n');
        return text.trimmed().isEmpty() || !hasWholeBlocks(text) ? std::nullopt : std::optional(text);
    }

    void analyse() {
        QStringList codes;
        QHash<QString, int> assignments;
        std::vector<VariableAssignment> values;
        static const QRegularExpression assignment(
            QStringLiteral("^(global\\s+|local\\s+)?([A-Za-z_]\\w*)\\s*=(?!=)\\s*(.+)$"));
        forEachStatement(main_, false, [&](const ScriptStatement& statement, bool inFunction) {
            isPendant_ = isPendant_ || statement.node > 0;
            if (statement.kind == Kind::Disabled) {
                for (int line = statement.first; line <= statement.last; ++line) {
                    disabledLines_.insert(line);
                }
            }
            codes << statement.code;
            for (const ScriptStatement::Branch& branch : statement.branches) {
                codes << branch.condition;
            }
            functionSetsTcp_ = functionSetsTcp_ || (inFunction && callsSetTcp(statement.code));
            const auto match = assignment.match(statement.code);
            if (statement.kind == Kind::Simple && match.hasMatch()) {
                ++assignments[match.captured(2)];
                values.push_back({match.captured(2), match.captured(3).trimmed(),
                                  match.captured(1).startsWith(QLatin1String("global")), inFunction});
            }
        });
        types_ = variableTypes(values);
        for (const VariableAssignment& value : values) {
            if (value.isGlobal && !value.isInFunction && assignments.value(value.name) == 1) {
                constants_.insert(value.name);
            }
        }
        code_ = codes.join(QLatin1Char('\n'));
    }

    /// How often a word occurs in the script, outside of strings.
    int occurrences(const QString& word) const {
        static const QRegularExpression text(QStringLiteral("\"[^\"\\n]*\""));
        const QRegularExpression whole(QStringLiteral("\\b%1\\b").arg(QRegularExpression::escape(word)));
        return static_cast<int>(QString(code_).remove(text).count(whole));
    }

    void convert() {
        out_ = {};
        out_.project = before_;
        keys_.clear();
        definitions_.clear();
        used_.clear();
        programs_.clear();
        texts_.clear();
        tcp_ = {};
        required_.reset();
        if (const auto* tool = before_.tooling.tools.find(before_.tooling.activeTool)) {
            required_ = tool->tcpOffset;
        }
        project::Program program;
        program.id = QUuid::createUuid();
        program.name = name_;
        out_.program = program.id;
        program.steps = block(main_);
        addTexts(program.steps);
        out_.project.programs.append(std::move(program));
        ++out_.programs;
    }

    /// Sets the texts of the text steps, which are joined only once because they can be long.
    void addTexts(std::vector<ProgramStep>& steps) const {
        for (ProgramStep& step : steps) {
            if (const auto text = texts_.constFind(step.id); text != texts_.constEnd()) {
                step.fields.insert(QStringLiteral("text"), text->join(QLatin1Char('\n')));
            }
            addTexts(step.steps);
        }
    }

    /// Returns  false if a variable or function was removed that the steps use
    bool keepReferenced() {
        QSet<QString> words;
        for (const project::Program& program : out_.project.programs) {
            if (before_.programs.find(program.id) == nullptr) {
                addWords(program.steps, words);
            }
        }
        const QSet<QString> omittedBefore = omitted_;
        for (const QString& name : used_) {
            if (!kept_.contains(name)) {
                omitted_.insert(name);
            }
        }
        for (QSet<QString> missing = QSet<QString>(omitted_).intersect(words); !missing.isEmpty();) {
            QSet<QString> further;
            for (const QString& name : missing) {
                // In the first pass, the words include those of the definitions.
                if (omittedBefore.contains(name)) {
                    kept_.insert(name);
                    omitted_.remove(name);
                    further.unite(wordsOf(definitions_.value(name).expression));
                }
            }
            missing = further.intersect(omitted_);
        }
        bool isComplete = omitted_ == omittedBefore;
        for (auto program = programs_.begin(); program != programs_.end(); ++program) {
            if (words.contains(program.key())) {
                keptFunctions_.insert(program.key());
                isComplete = false;
            }
        }
        return isComplete;
    }

    /// Returns  false if a statement that is already text has a problem
    bool deny(const std::vector<ProgramProblem>& problems) {
        const qsizetype before = denied_.size();
        for (const ProgramProblem& problem : problems) {
            if (const auto key = keys_.constFind(problem.step); key != keys_.constEnd()) {
                if (!denied_.contains(*key)) {
                    denied_.insert(*key, problem.text);
                }
            }
        }
        return denied_.size() > before;
    }

    bool isCompiled(const QString& script) const {
        const SoftwareVersion version = ScriptOptions().version;
        return !simulator::ScriptRun::check(script, version) ||
               simulator::ScriptRun::check(lines_.join(QLatin1Char('\n')), version);
    }

    Result<ImportedProgram> asText(const QString& text, const QString& reason) {
        out_ = {};
        out_.project = before_;
        project::Program program;
        program.id = QUuid::createUuid();
        program.name = name_;
        program.steps = {makeStep("script", {{"text", text}})};
        out_.program = program.id;
        out_.programs = 1;
        out_.project.programs.append(program);
        out_.rows = {{0, name_, Row::Result::Text, QStringLiteral("script"), reason, false}};
        forEachStatement(main_, false, [&](const ScriptStatement& statement, bool) {
            if (statement.kind == Kind::Disabled || statement.kind == Kind::Omitted) {
                addRow(statement, Row::Result::Omitted, {}, QStringLiteral("disabled"));
            }
        });
        const ProgramScript script = writeScript(out_.project, out_.program);
        if (!script.ok()) {
            return Error{ErrorCode::ScriptError, script.problems.front().text, {}};
        }
        addNotes(script);
        return out_;
    }

    void addNotes(const ProgramScript& script) {
        static const QRegularExpression used(
            QStringLiteral("(read|write)_output_integer_register\\(\\s*(46|47)\\b"));
        if (!lines_.filter(used).isEmpty()) {
            out_.notes << QStringLiteral(
                "The program uses output integer register 46 or 47, in which Tiller "
                "writes the number of the running step.");
        }
        if (const auto* tool = before_.tooling.tools.find(before_.tooling.activeTool)) {
            out_.notes << QStringLiteral("In this project, programs begin with the TCP of the tool '%1'.")
                              .arg(tool->name);
        } else if (script.tcp && !callsSetTcp(script.text)) {
            out_.notes << QStringLiteral(
                              "The program does not set the TCP. Its waypoints require the TCP %1.")
                              .arg(poseText(*script.tcp));
        }
    }

    // ---- text -------------------------------------------------------------------------------------------

    QString textOf(const Statements& list) const {
        QStringList texts;
        for (const ScriptStatement& statement : list) {
            const QString text = textOf(statement);
            if (!text.isEmpty()) {
                texts << text;
            }
        }
        return texts.join(QLatin1Char('\n'));
    }

    /// The lines of a statement without labels, disabled nodes and common indentation.
    QString textOf(const ScriptStatement& statement) const {
        static const QRegularExpression label(QStringLiteral("^\\s*\\$\\s*\\d+\\s*\".*\"\\s*$"));
        static const QRegularExpression notSpace(QStringLiteral("\\S"));
        if (statement.kind == Kind::Folder) {
            return textOf(statement.body);
        }
        const bool isMark =
            statement.kind == Kind::Disabled || statement.kind == Kind::Omitted ||
            (statement.kind == Kind::Comment && statement.node > 0 && statement.last < statement.first);
        QStringList texts;
        qsizetype indent = std::numeric_limits<qsizetype>::max();
        for (int line = statement.first; !isMark && line <= statement.last; ++line) {
            const QString& text = lines_[line];
            if (!disabledLines_.contains(line) && !text.trimmed().isEmpty() &&
                !label.match(text).hasMatch()) {
                indent = std::min(indent, text.indexOf(notSpace));
                texts << text;
            }
        }
        for (QString& text : texts) {
            text.remove(0, indent);
        }
        return texts.join(QLatin1Char('\n'));
    }

    void addRow(const ScriptStatement& statement, Row::Result result, const QString& kind,
                const QString& reason = {}) {
        constexpr qsizetype kMaxName = 70;
        QString name = statement.node > 0 ? statement.nodeName : statement.code;
        if (name.isEmpty() && statement.kind == Kind::If) {
            name = QStringLiteral("if ") + statement.branches.front().condition;
        }
        if (name.size() > kMaxName) {
            name = name.left(kMaxName - 1) + QChar(0x2026);
        }
        const int line = isPendant_ ? statement.node : statement.first + 1;
        out_.rows.push_back({line, name, result, kind, reason, false});
    }

    void addText(std::vector<ProgramStep>& steps, const ScriptStatement& statement, const QString& reason) {
        const QString text = textOf(statement);
        if (callsSetTcp(text)) {
            tcp_.kind = Tcp::Kind::Unknown;
        }
        const bool joins = !steps.empty() && steps.back().id == lastText_ && lastNode_ == statement.node &&
                           steps.back().kind == QLatin1String("script");
        if (!joins) {
            steps.push_back(makeStep("script"));
            lastText_ = steps.back().id;
            lastNode_ = statement.node;
        }
        texts_[lastText_] << text;
        keys_.insert(steps.back().id, statement.first);
        if (!joins || !isPendant_ || statement.node == 0) {
            addRow(statement, Row::Result::Text, QStringLiteral("script"), reason);
        }
        const auto report = [&](const ScriptStatement& inner, bool) {
            if (inner.kind == Kind::Disabled || inner.kind == Kind::Omitted) {
                addRow(inner, Row::Result::Omitted, {},
                       QStringLiteral("a disabled node in a part that is text"));
            }
        };
        forEachStatement(statement.body, false, report);
        for (const ScriptStatement::Branch& branch : statement.branches) {
            forEachStatement(branch.body, false, report);
        }
    }

    // ---- blocks -----------------------------------------------------------------------------------------

    void addStep(std::vector<ProgramStep>& steps, ProgramStep step, const ScriptStatement& statement) {
        keys_.insert(step.id, statement.first);
        steps.push_back(std::move(step));
    }

    std::vector<ProgramStep> block(const Statements& list) {
        std::vector<ProgramStep> steps;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const ScriptStatement& statement = list[i];
            const auto denied = denied_.constFind(statement.first);
            const bool mayConvert = denied == denied_.constEnd();
            switch (statement.kind) {
                case Kind::Comment:
                    addComment(steps, list, i);
                    break;
                case Kind::Omitted:
                    addRow(statement, Row::Result::Omitted, {}, statement.code);
                    out_.rows.back().name.clear();
                    break;
                case Kind::Folder:
                    addFolder(steps, statement);
                    break;
                case Kind::Disabled:
                    addDisabled(steps, statement);
                    break;
                default:
                    if (!mayConvert) {
                        addText(steps, statement, *denied);
                    } else if (addCountingLoop(steps, list, i) || addSwitch(steps, list, i)) {
                        ++i;
                    } else if (!addConverted(steps, statement)) {
                        addText(steps, statement, std::exchange(reason_, kNoStep));
                    }
                    break;
            }
        }
        return steps;
    }

    void addFolder(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        const bool isNode = statement.node > 0;
        if (isNode) {
            addRow(statement, Row::Result::Step, QStringLiteral("folder"));
        }
        ProgramStep folder = makeStep("folder", {{"name", statement.code}});
        ++depth_;
        folder.steps = block(statement.body);
        --depth_;
        if (isNode || !folder.steps.empty()) {
            addStep(steps, std::move(folder), statement);
        }
    }

    void addComment(std::vector<ProgramStep>& steps, const Statements& list, std::size_t& i) {
        const ScriptStatement& first = list[i];
        QStringList texts{first.code};
        while (!isPendant_ && i + 1 < list.size() && list[i + 1].kind == Kind::Comment) {
            texts << list[++i].code;
        }
        addStep(steps, makeStep("comment", {{"text", texts.join(QLatin1Char('\n'))}}), first);
        addRow(first, Row::Result::Step, QStringLiteral("comment"));
    }

    void addDisabled(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        const Tcp tcp = tcp_;
        const std::size_t rows = out_.rows.size();
        std::vector<ProgramStep> disabled = block(statement.body);
        for (ProgramStep& step : disabled) {
            step.disabled = true;
            steps.push_back(std::move(step));
        }
        for (std::size_t row = rows; row < out_.rows.size(); ++row) {
            out_.rows[row].disabled = true;
        }
        tcp_ = tcp;
        lastText_ = {};
    }

    bool addConverted(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        reason_ = kNoStep;
        if (depth_ >= project::kMaxProgramDepth / 2 && statement.kind != Kind::Simple) {
            reason_ = QStringLiteral("it is nested too deep");
            return false;
        }
        switch (statement.kind) {
            case Kind::If:
                return addIf(steps, statement);
            case Kind::While:
                return addWhile(steps, statement);
            case Kind::Function:
                return addFunction(statement);
            default:
                break;
        }
        if (takeDefinition(statement)) {
            return true;
        }
        std::optional<ProgramStep> step = simpleStep(statement);
        if (!step) {
            if (const auto tcp = literalTcp(statement.code)) {
                addText(steps, statement, QStringLiteral("the TCP applies until the end of the program"));
                tcp_ = {functionSetsTcp_ ? Tcp::Kind::Unknown : Tcp::Kind::Known, *tcp};
                required_ = *tcp;
                return true;
            }
            return false;
        }
        addRow(statement, Row::Result::Step, step->kind);
        addStep(steps, std::move(*step), statement);
        return true;
    }

    std::vector<ProgramStep> innerBlock(const Statements& list, bool repeats) {
        const Tcp before = tcp_;
        bool sets = false;
        forEachStatement(list, false, [&](const ScriptStatement& statement, bool) {
            sets = sets || callsSetTcp(statement.code);
        });
        if (repeats && sets) {
            tcp_.kind = Tcp::Kind::Unknown;
        }
        ++depth_;
        std::vector<ProgramStep> steps = block(list);
        --depth_;
        tcp_ = before;
        if (sets) {
            tcp_.kind = Tcp::Kind::Unknown;
        }
        return steps;
    }

    bool addIf(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        const bool allConditions =
            std::all_of(statement.branches.begin(), statement.branches.end(), [](const auto& branch) {
                return branch.condition.isEmpty() || isExpression(withoutBrackets(branch.condition));
            });
        if (!allConditions) {
            reason_ = QStringLiteral("its condition cannot be a condition of a step");
            return false;
        }
        addRow(statement, Row::Result::Step, QStringLiteral("if"));
        addBranches(steps, statement, statement, true);
        return true;
    }

    void addBranches(std::vector<ProgramStep>& steps, const ScriptStatement& chain,
                     const ScriptStatement& statement, bool isFirst) {
        for (const ScriptStatement::Branch& branch : statement.branches) {
            const QString condition = withoutBrackets(branch.condition);
            // The pendant writes "else if" as an If in the Else.
            const ScriptStatement* inner =
                condition.isEmpty() && branch.body.size() == 1 ? &branch.body.front() : nullptr;
            const bool continues =
                inner != nullptr && inner->kind == Kind::If && !denied_.contains(inner->first) &&
                std::all_of(inner->branches.begin(), inner->branches.end(), [](const auto& each) {
                    return each.condition.isEmpty() || isExpression(withoutBrackets(each.condition));
                });
            if (continues) {
                addRow(*inner, Row::Result::Step, QStringLiteral("elseIf"));
                addBranches(steps, chain, *inner, false);
                return;
            }
            ProgramStep step = condition.isEmpty()
                                   ? makeStep("else")
                                   : makeStep(isFirst ? "if" : "elseIf", {{"condition", condition}});
            isFirst = false;
            step.steps = innerBlock(branch.body, false);
            addStep(steps, std::move(step), chain);
        }
    }

    bool addWhile(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        if (addWait(steps, statement)) {
            return true;
        }
        const QString condition = withoutBrackets(statement.code);
        const bool isEndless = flagLiteral(condition) == true;
        if (!isEndless && !isExpression(condition)) {
            reason_ = QStringLiteral("its condition cannot be a condition of a step");
            return false;
        }
        ProgramStep step =
            isEndless ? makeStep("loop", {{"times", 0}}) : makeStep("while", {{"condition", condition}});
        addRow(statement, Row::Result::Step, step.kind);
        step.steps = innerBlock(statement.body, true);
        addStep(steps, std::move(step), statement);
        return true;
    }

    bool addWait(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        static const QRegularExpression input(
            QStringLiteral("^get_(standard|configurable|tool)_digital_in\\((\\d+)\\) == (True|False)$"));
        const auto call = parseCall(statement.code);
        if (statement.body.size() != 1 || statement.body.front().code != QLatin1String("sync()") || !call ||
            call->function != QLatin1String("not") || call->arguments.size() != 1 ||
            !call->arguments.front().name.isEmpty()) {
            return false;
        }
        const QString condition = call->arguments.front().text;
        const auto match = input.match(condition);
        const auto channel =
            match.hasMatch() ? channelOf(match.captured(1), match.captured(2)) : std::optional<int>();
        if (!channel && !isExpression(condition)) {
            return false;
        }
        ProgramStep step =
            channel ? makeStep("waitInput",
                               {{"input", *channel}, {"value", match.captured(3) == QLatin1String("True")}})
                    : makeStep("waitCondition", {{"condition", condition}});
        addRow(statement, Row::Result::Step, step.kind);
        addStep(steps, std::move(step), statement);
        return true;
    }

    /// A counter that only counts the repetitions of the loop after it.
    bool addCountingLoop(std::vector<ProgramStep>& steps, const Statements& list, std::size_t i) {
        static const QRegularExpression start(QStringLiteral("^(?:global\\s+)?(\\w+)\\s*=\\s*0$"));
        constexpr int kMaxTimes = 1'000'000;
        constexpr int kUses = 4;  // start, condition, and twice in the increment
        if (list[i].kind != Kind::Simple || i + 1 >= list.size() || list[i + 1].kind != Kind::While ||
            denied_.contains(list[i + 1].first)) {
            return false;
        }
        const auto match = start.match(list[i].code);
        const ScriptStatement& loop = list[i + 1];
        if (!match.hasMatch() || loop.body.size() < 2) {
            return false;
        }
        const QString counter = match.captured(1);
        const QRegularExpression condition(QStringLiteral("^%1\\s*<\\s*(\\d+)$").arg(counter));
        const QRegularExpression increment(QStringLiteral("^%1\\s*=\\s*%1\\s*\\+\\s*1$").arg(counter));
        const auto limit = condition.match(withoutBrackets(loop.code));
        const int times = limit.captured(1).toInt();
        if (!limit.hasMatch() || times < 1 || times > kMaxTimes ||
            !increment.match(loop.body.back().code).hasMatch() || occurrences(counter) != kUses ||
            hasWord(loop.body, QStringLiteral("continue"))) {
            return false;
        }
        addRow(loop, Row::Result::Step, QStringLiteral("loop"));
        ProgramStep step = makeStep("loop", {{"times", times}});
        step.steps = innerBlock(Statements(loop.body.begin(), loop.body.end() - 1), true);
        addStep(steps, std::move(step), list[i]);
        return true;
    }

    /// As written for the Switch node of the pendant.
    bool addSwitch(std::vector<ProgramStep>& steps, const Statements& list, std::size_t i) {
        static const QRegularExpression value(QStringLiteral("^(switch_\\d+)\\s*=\\s*(.+)$"));
        const auto match = value.match(list[i].code);
        if (list[i].kind != Kind::Simple || !match.hasMatch() || i + 1 >= list.size() ||
            list[i + 1].kind != Kind::If || denied_.contains(list[i + 1].first) ||
            !isExpression(match.captured(2))) {
            return false;
        }
        const QRegularExpression compared(QStringLiteral("^(.+) == %1$").arg(match.captured(1)));
        const ScriptStatement& cases = list[i + 1];
        QStringList values;
        for (const ScriptStatement::Branch& branch : cases.branches) {
            const auto one = compared.match(withoutBrackets(branch.condition));
            if (!branch.condition.isEmpty() && !(one.hasMatch() && numberLiteral(one.captured(1)))) {
                return false;
            }
            values << (branch.condition.isEmpty() ? QString() : one.captured(1));
        }
        const qsizetype conditions = values.size() - values.count(QString());
        if (occurrences(match.captured(1)) != conditions + 1) {
            return false;
        }
        addRow(list[i], Row::Result::Step, QStringLiteral("switch"));
        ProgramStep step = makeStep("switch", {{"value", match.captured(2)}});
        for (std::size_t at = 0; at < cases.branches.size(); ++at) {
            const QString& wanted = values[static_cast<qsizetype>(at)];
            ProgramStep part = wanted.isEmpty() ? makeStep("default") : makeStep("case", {{"value", wanted}});
            part.steps = innerBlock(cases.branches[at].body, false);
            addStep(step.steps, std::move(part), list[i]);
        }
        addStep(steps, std::move(step), list[i]);
        return true;
    }

    /// A function without parameters that is only called as a statement becomes a program.
    bool addFunction(const ScriptStatement& statement) {
        static const QRegularExpression def(QStringLiteral("^def\\s+(\\w+)\\s*\\(\\s*\\)\\s*:$"));
        const auto match = def.match(statement.code);
        if (!match.hasMatch() || keptFunctions_.contains(match.captured(1)) ||
            hasWord(statement.body, QStringLiteral("return"))) {
            reason_ =
                QStringLiteral("it is a function with parameters or a result, or a thread, or part of one");
            return false;
        }
        const QString name = match.captured(1);
        if (occurrences(name) < 2) {
            reason_ = QStringLiteral("the program does not call this function");
            return false;
        }
        addRow(statement, Row::Result::Step, QStringLiteral("call"), QStringLiteral("a program"));
        const Tcp tcp = tcp_;
        if (callsSetTcpAfter(statement.last)) {
            tcp_.kind = Tcp::Kind::Unknown;
        }
        project::Program program;
        program.id = QUuid::createUuid();
        program.name = out_.project.programs.uniqueName(name_ + QStringLiteral(": ") + name);
        program.steps = block(statement.body);
        addTexts(program.steps);
        tcp_ = tcp;
        if (program.steps.empty()) {
            program.steps.push_back(makeStep("comment"));
        }
        programs_.insert(name, program.id);
        out_.project.programs.append(std::move(program));
        ++out_.programs;
        return true;
    }

    bool callsSetTcpAfter(int line) const {
        return std::any_of(lines_.begin() + line, lines_.end(), callsSetTcp);
    }

    // ---- definitions and positions ----------------------------------------------------------------------

    /// Returns  true if the statement only defines a position that is a waypoint now
    bool takeDefinition(const ScriptStatement& statement) {
        static const QRegularExpression global(QStringLiteral("^global\\s+(\\w+)\\s*=(?!=)\\s*(.+)$"));
        const auto match = global.match(statement.code);
        const QString name = match.captured(1);
        if (!match.hasMatch() || !constants_.contains(name)) {
            return false;
        }
        definitions_.insert(name, {match.captured(2).trimmed(), tcp_});
        if (omitted_.contains(name)) {
            addRow(statement, Row::Result::Merged, {}, QStringLiteral("part of a waypoint"));
            return true;
        }
        return false;
    }

    static std::optional<Pose> literalPose(const QString& text) {
        const auto values = listLiteral(text, QStringLiteral("p"), 6);
        return values ? std::optional(Pose::fromStdVector(*values)) : std::nullopt;
    }
    static std::optional<Pose> literalTcp(const QString& code) {
        const auto call = parseCall(code);
        return call && call->function == QLatin1String("set_tcp") && call->arguments.size() == 1
                   ? literalPose(call->arguments.front().text)
                   : std::nullopt;
    }

    /// True if the TCP of the program at this statement is this one.
    bool isTcp(const Pose& tcp) {
        if (tcp_.kind == Tcp::Kind::Known) {
            return isSame(tcp_.value, tcp);
        }
        if (tcp_.kind == Tcp::Kind::Initial) {
            // The program requires this TCP; see ProgramScript::tcp.
            required_ = required_.value_or(tcp);
            return isSame(*required_, tcp);
        }
        return false;
    }
    bool isSameTcp(const Tcp& then) const {
        return tcp_.kind == then.kind && tcp_.kind != Tcp::Kind::Unknown && isSame(tcp_.value, then.value);
    }

    /// Joint positions that the expression stands for, as a list.
    std::optional<Target> jointsOf(const QString& expression) {
        if (const auto values = listLiteral(expression, {}, 6)) {
            return Target{JointPositions(*values), {}, {}, {}};
        }
        const auto known = definitions_.constFind(expression);
        if (known == definitions_.constEnd()) {
            return std::nullopt;
        }
        const auto values = listLiteral(known->expression, {}, 6);
        return values ? std::optional(Target{JointPositions(*values), expression, {expression}, {}})
                      : std::nullopt;
    }

    /// Joint positions whose pose with the current TCP is the value of the expression.
    std::optional<Target> jointsOfPose(const QString& expression) {
        if (const auto known = definitions_.constFind(expression); known != definitions_.constEnd()) {
            const Definition definition = *known;
            const auto call = parseCall(definition.expression);
            if (!call || (call->arguments.size() == 1 && !isSameTcp(definition.tcp))) {
                return std::nullopt;
            }
            auto target = jointsOfPose(definition.expression);
            if (target) {
                target->name = expression;
                target->defined << expression;
            }
            return target;
        }
        const auto call = parseCall(expression);
        if (!call || call->function != QLatin1String("get_forward_kin") || call->arguments.empty() ||
            call->arguments.size() > 2) {
            return std::nullopt;
        }
        const auto values = call->bind({QStringLiteral("q"), QStringLiteral("tcp")});
        if (!values || values->front().isEmpty()) {
            return std::nullopt;
        }
        if (!values->back().isEmpty()) {
            const auto tcp = literalPose(values->back());
            if (!tcp || !isTcp(*tcp)) {
                return std::nullopt;
            }
        } else if (tcp_.kind == Tcp::Kind::Unknown) {
            return std::nullopt;
        }
        return jointsOf(values->front());
    }

    std::optional<Target> targetOf(const QString& expression, bool joint) {
        if (const auto target = jointsOf(expression)) {
            return target;
        }
        if (const auto target = jointsOfPose(expression)) {
            return target;
        }
        const auto call = parseCall(expression);
        if (joint && call && call->function == QLatin1String("get_inverse_kin")) {
            const auto values = call->bind({QStringLiteral("x"), QStringLiteral("qnear")});
            if (!values || values->front().isEmpty()) {
                return std::nullopt;
            }
            if (values->back().isEmpty()) {
                return poseTarget(values->front());
            }
            auto target = jointsOfPose(values->front());
            const auto near = jointsOf(values->back());
            if (!target || !near || *target->joints != *near->joints) {
                return std::nullopt;
            }
            target->defined << near->defined;
            return target;
        }
        const bool isPose =
            typeOf(expression, types_) == QLatin1String("pose") ||
            (definitions_.contains(expression) &&
             typeOf(definitions_.value(expression).expression, types_) == QLatin1String("pose"));
        return !joint || isPose ? poseTarget(expression) : std::nullopt;
    }

    static std::optional<Target> poseTarget(const QString& expression) {
        return isExpression(expression) ? std::optional(Target{{}, {}, {}, expression}) : std::nullopt;
    }

    /// The waypoint of the imported program at these joint positions.
    /// label   its name; may be empty
    /// values  speed and blend of a new waypoint
    QUuid waypointFor(const Target& target, const QString& label, const project::Waypoint& values) {
        required_ = required_.value_or(tcp_.kind == Tcp::Kind::Known ? tcp_.value : Pose());
        const Pose tcp = tcp_.kind == Tcp::Kind::Known ? tcp_.value : *required_;
        QString wanted = !label.isEmpty() ? label : target.name;
        if (label.isEmpty() &&
            (wanted.endsWith(QLatin1String("_q")) || wanted.endsWith(QLatin1String("_p")))) {
            wanted.chop(2);
        }
        const auto& known = out_.project.waypoints;
        for (int i = before_.waypoints.size(); i < known.size(); ++i) {
            const project::Waypoint& point = known.at(i);
            if (point.joints == *target.joints && isSame(point.tcpOffset, tcp) &&
                (wanted.isEmpty() || point.name == wanted)) {
                return point.id;
            }
        }
        project::Waypoint point = values;
        point.id = QUuid::createUuid();
        point.name = known.uniqueName(
            wanted.isEmpty() ? QStringLiteral("%1 %2").arg(name_).arg(out_.waypoints + 1) : wanted);
        point.group = name_;
        point.ruling = project::TargetKind::Joints;
        point.tcpOffset = tcp;
        point.joints = *target.joints;
        const RobotModelId model = before_.robot.value_or(RobotModelId::UR5e);
        point.pose = kinematics::forwardTcp(robotModel(model).dh, point.joints, tcp);
        out_.project.waypoints.append(point);
        ++out_.waypoints;
        return point.id;
    }

    void use(const Target& target) {
        for (const QString& name : target.defined) {
            used_.insert(name);
        }
    }

    std::optional<ProgramStep> moveStep(const ScriptCall& call, const ScriptStatement& statement) {
        const bool joint = call.function == QLatin1String("movej");
        const bool process = call.function == QLatin1String("movep");
        const QString target = joint ? QStringLiteral("q") : QStringLiteral("pose");
        const auto values = process ? call.bind({target, QStringLiteral("a"), QStringLiteral("v"),
                                                 QStringLiteral("r"), QStringLiteral("t")})
                                    : call.bind({target, QStringLiteral("a"), QStringLiteral("v"),
                                                 QStringLiteral("t"), QStringLiteral("r")});
        if (!values || values->front().isEmpty() || (process && !values->at(4).isEmpty())) {
            return std::nullopt;
        }
        const auto numberAt = [&](qsizetype at, double initial) {
            return values->at(at).isEmpty() ? std::optional(initial) : numberLiteral(values->at(at));
        };
        // The initial values are those of the controller.
        const auto acceleration = numberAt(1, joint ? 1.4 : 1.2);
        const auto speed = numberAt(2, joint ? 1.05 : 0.25);
        const auto time = process ? std::optional(0.0) : numberAt(3, 0);
        const auto blend = numberAt(process ? 3 : 4, 0);
        if (!acceleration || !speed || !blend || time != 0) {
            reason_ = QStringLiteral("the speed, acceleration or blend is not a number, or a time is set");
            return std::nullopt;
        }
        const auto found = targetOf(values->front(), joint);
        if (!found) {
            reason_ = QStringLiteral("its target cannot be a waypoint or a pose of a step");
            return std::nullopt;
        }
        ProgramStep step = makeStep(joint     ? "moveJ"
                                    : process ? "moveP"
                                              : "moveL",
                                    {{"acceleration", *acceleration}, {"speed", *speed}, {"blend", *blend}});
        if (found->joints) {
            project::Waypoint point;
            point.move = joint ? project::MoveKind::Joint : project::MoveKind::Linear;
            (joint ? point.jointSpeed : point.toolSpeed) = *speed;
            point.blend = *blend;
            use(*found);
            step.fields.insert(
                QStringLiteral("waypoint"),
                idOf(waypointFor(*found, statement.node > 0 ? statement.nodeName : QString(), point)));
        } else {
            step.fields.insert(QStringLiteral("pose"), found->pose);
        }
        return step;
    }

    std::optional<ProgramStep> circleStep(const ScriptCall& call) {
        const auto values =
            call.bind({QStringLiteral("pose_via"), QStringLiteral("pose_to"), QStringLiteral("a"),
                       QStringLiteral("v"), QStringLiteral("r"), QStringLiteral("mode")});
        if (!values || values->at(0).isEmpty() || values->at(1).isEmpty()) {
            return std::nullopt;
        }
        const auto numberAt = [&](qsizetype at, double initial) {
            return values->at(at).isEmpty() ? std::optional(initial) : numberLiteral(values->at(at));
        };
        const auto acceleration = numberAt(2, 1.2);
        const auto speed = numberAt(3, 0.25);
        const auto blend = numberAt(4, 0);
        const auto mode = numberAt(5, 0);
        const auto via = jointsOfPose(values->at(0));
        const auto end = jointsOfPose(values->at(1));
        if (!acceleration || !speed || !blend || (mode != 0 && mode != 1) || !via || !end) {
            return std::nullopt;
        }
        project::Waypoint point;
        point.move = project::MoveKind::Linear;
        point.toolSpeed = *speed;
        use(*via);
        use(*end);
        return makeStep("moveCircle", {{"via", idOf(waypointFor(*via, {}, point))},
                                       {"waypoint", idOf(waypointFor(*end, {}, point))},
                                       {"acceleration", *acceleration},
                                       {"speed", *speed},
                                       {"blend", *blend},
                                       {"orientation", mode == 1 ? "fixed" : "free"}});
    }

    // ---- other statements -------------------------------------------------------------------------------

    std::optional<ProgramStep> simpleStep(const ScriptStatement& statement) {
        const QString& code = statement.code;
        if (code == QLatin1String("break")) {
            return makeStep("leaveLoop");
        }
        if (code == QLatin1String("halt")) {
            return makeStep("end");
        }
        static const QRegularExpression assignment(
            QStringLiteral("^(global\\s+)?([A-Za-z_]\\w*)\\s*=(?!=)\\s*(.+)$"));
        if (const auto match = assignment.match(code); match.hasMatch()) {
            return assignStep(match.captured(2), match.captured(3).trimmed());
        }
        const auto call = parseCall(code);
        if (!call) {
            return std::nullopt;
        }
        const QString& function = call->function;
        if (call->arguments.empty() && programs_.contains(function)) {
            return makeStep("call", {{"program", idOf(programs_.value(function))}});
        }
        if (function == QLatin1String("movej") || function == QLatin1String("movel") ||
            function == QLatin1String("movep")) {
            return moveStep(*call, statement);
        }
        if (function == QLatin1String("movec")) {
            return circleStep(*call);
        }
        if (function == QLatin1String("sleep")) {
            const auto values = call->bind({QStringLiteral("t")});
            const auto time = values ? numberLiteral(values->front()) : std::nullopt;
            return time ? std::optional(makeStep("wait", {{"time", *time}})) : std::nullopt;
        }
        if (function == QLatin1String("popup")) {
            return messageStep(*call);
        }
        if (function == QLatin1String("textmsg")) {
            return logStep(*call);
        }
        if (function == QLatin1String("set_payload")) {
            return payloadStepFor(*call);
        }
        return outputStep(*call);
    }

    std::optional<ProgramStep> assignStep(const QString& name, const QString& value) {
        static const QRegularExpression request(
            QStringLiteral("^request_(boolean|integer|float|string)_from_primary_client$"));
        const auto call = parseCall(value);
        const QString type = types_.value(name);
        if (type.isEmpty()) {
            reason_ = QStringLiteral("the type or the scope of the variable is not certain");
            return std::nullopt;
        }
        if (const auto match = call ? request.match(call->function) : QRegularExpressionMatch();
            match.hasMatch()) {
            const auto text =
                call->arguments.size() == 1 ? plainString(call->arguments.front().text) : std::nullopt;
            return text ? std::optional(
                              makeStep("question", {{"text", *text}, {"variable", name}, {"type", type}}))
                        : std::nullopt;
        }
        return isExpression(value)
                   ? std::optional(makeStep("assign", {{"variable", name}, {"type", type}, {"value", value}}))
                   : std::nullopt;
    }

    std::optional<ProgramStep> messageStep(const ScriptCall& call) {
        static const QStringList kTitles{QStringLiteral("\"Message\""), QStringLiteral("\"Warning\""),
                                         QStringLiteral("\"Error\""), QStringLiteral("\"Popup\""),
                                         QStringLiteral("\"Tiller\"")};
        const auto values =
            call.bind({QStringLiteral("s"), QStringLiteral("title"), QStringLiteral("warning"),
                       QStringLiteral("error"), QStringLiteral("blocking")});
        if (!values) {
            return std::nullopt;
        }
        const auto flagAt = [&](qsizetype at) {
            return values->at(at).isEmpty() ? std::optional(false) : flagLiteral(values->at(at));
        };
        const auto text = plainString(values->front());
        const auto warning = flagAt(2), error = flagAt(3), waits = flagAt(4);
        if (!values->at(1).isEmpty() && !kTitles.contains(values->at(1))) {
            reason_ = QStringLiteral("the Message step has no title");
            return std::nullopt;
        }
        if (!text || !warning || !error || !waits || (*warning && *error)) {
            return std::nullopt;
        }
        return makeStep("message", {{"text", *text},
                                    {"level", *error     ? "error"
                                              : *warning ? "warning"
                                                         : "message"},
                                    {"waits", *waits}});
    }

    static std::optional<ProgramStep> logStep(const ScriptCall& call) {
        const auto values = call.bind({QStringLiteral("s1"), QStringLiteral("s2")});
        const auto text = values ? plainString(values->front()) : std::nullopt;
        if (!text || (!values->back().isEmpty() && !isExpression(values->back()))) {
            return std::nullopt;
        }
        ProgramStep step = makeStep("log", {{"text", *text}});
        if (!values->back().isEmpty()) {
            step.fields.insert(QStringLiteral("value"), values->back());
        }
        return step;
    }

    std::optional<ProgramStep> payloadStepFor(const ScriptCall& call) {
        const auto values = call.bind({QStringLiteral("m"), QStringLiteral("cog")});
        const auto mass = values ? numberLiteral(values->front()) : std::nullopt;
        const auto centre = values ? listLiteral(values->back(), {}, 3) : std::nullopt;
        if (!mass || !centre || *mass < 0 || *mass > project::kHeaviestPayload ||
            std::any_of(centre->begin(), centre->end(),
                        [](double value) { return std::abs(value) > project::kFarthestPayload; })) {
            reason_ = QStringLiteral("the payload is not given by numbers");
            return std::nullopt;
        }
        const Eigen::Vector3d point((*centre)[0], (*centre)[1], (*centre)[2]);
        project::PayloadList& payloads = out_.project.tooling.payloads;
        const auto same =
            std::find_if(payloads.begin(), payloads.end(), [&](const project::Payload& payload) {
                return payload.mass == *mass && payload.centre == point;
            });
        if (same != payloads.end()) {
            return makeStep("payload", {{"payload", idOf(same->id)}});
        }
        project::Payload payload;
        payload.id = QUuid::createUuid();
        payload.name = payloads.uniqueName(QStringLiteral("%1 kg").arg(*mass));
        payload.mass = *mass;
        payload.centre = point;
        payloads.append(payload);
        return makeStep("payload", {{"payload", idOf(payload.id)}});
    }

    static std::optional<ProgramStep> outputStep(const ScriptCall& call) {
        static const QRegularExpression digital(
            QStringLiteral("^set_(?:(standard|configurable|tool)_)?digital_out$"));
        static const QRegularExpression reg(
            QStringLiteral("^write_output_(integer|float|boolean)_register$"));
        if (call.arguments.size() != 2 || !call.arguments[0].name.isEmpty() ||
            !call.arguments[1].name.isEmpty()) {
            return std::nullopt;
        }
        const QString& pin = call.arguments[0].text;
        const QString& value = call.arguments[1].text;
        if (const auto match = digital.match(call.function); match.hasMatch()) {
            const auto channel = channelOf(match.captured(1), pin);
            const auto on = flagLiteral(value);
            return channel && on
                       ? std::optional(makeStep("setOutput", {{"output", *channel}, {"value", *on}}))
                       : std::nullopt;
        }
        if (call.function == QLatin1String("set_standard_analog_out")) {
            const auto number = wholeLiteral(pin);
            const auto level = numberLiteral(value);
            return number && level
                       ? std::optional(makeStep("setAnalogOutput", {{"output", *number}, {"level", *level}}))
                       : std::nullopt;
        }
        if (const auto match = reg.match(call.function); match.hasMatch()) {
            const auto number = wholeLiteral(pin);
            return number && isExpression(value)
                       ? std::optional(
                             makeStep("setRegister",
                                      {{"type", match.captured(1)}, {"register", *number}, {"value", value}}))
                       : std::nullopt;
        }
        return std::nullopt;
    }

    const project::Project& before_;
    const QString name_;
    const QStringList& lines_;
    Statements main_;
    QString code_;  ///< of all statements
    bool isPendant_ = false;
    bool functionSetsTcp_ = false;
    QSet<int> disabledLines_;
    QHash<QString, QString> types_;  ///< of the variables, as in the field `type`
    QSet<QString> constants_;        ///< global variables with one assignment
    // decisions of earlier passes
    QHash<int, QString> denied_;  ///< statements that must be text, with the reason
    QSet<QString> omitted_;       ///< definitions that are part of waypoints
    QSet<QString> kept_;          ///< definitions that the text uses
    QSet<QString> keptFunctions_;
    // state of a pass
    ImportedProgram out_;
    QHash<QUuid, int> keys_;  ///< first line of the statement of each step
    QHash<QString, Definition> definitions_;
    QSet<QString> used_;  ///< definitions of waypoints
    QHash<QString, QUuid> programs_;
    Tcp tcp_;
    std::optional<Pose> required_;  ///< TCP at the start
    QString reason_;
    QHash<QUuid, QStringList> texts_;  ///< of the text steps
    int depth_ = 0;                    ///< number of sections around the current statement
    QUuid lastText_;
    int lastNode_ = 0;
};

}  // namespace

Result<ImportedProgram> importStatements(const project::Project& project, const QString& name,
                                         const QStringList& lines,
                                         const std::vector<simulator::pendant::NodeMark>& marks) {
    return StatementImport(project, name, lines).run(marks);
}

}  // namespace tiller::program
