// SPDX-License-Identifier: MIT
#include "robot/station/program/import/statement_import.h"

#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <limits>
#include <utility>

#include "robot/simulator/script_run.h"
#include "robot/station/program/expression.h"
#include "robot/station/program/import/call_steps.h"
#include "robot/station/program/import/move_import.h"
#include "robot/station/program/import/script_outline.h"
#include "robot/station/program/import/script_statements.h"
#include "robot/station/program/program_script.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {

using project::ProgramStep;

namespace {

using Kind = ScriptStatement::Kind;
using Row = ImportRow;

constexpr int kMaxPasses = 50;

QString noStep() {
    return ProgramText::tr("no step corresponds to this statement");
}

QString poseText(const Pose& pose) {
    QStringList numbers;
    for (const double number : pose.array()) {
        numbers << QString::number(number);
    }
    return QStringLiteral("p[%1]").arg(numbers.join(QStringLiteral(", ")));
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
            const auto text = outline_.textOfDefinition();
            return text ? asText(*text, split.error().context)
                        : Result<ImportedProgram>(Error{ErrorCode::ScriptError, split.error().context, {}});
        }
        if (const QString why = outline_.findMain(std::move(*split)); !why.isEmpty()) {
            return Error{ErrorCode::ScriptError, why, {}};
        }
        if (hasWord(outline_.main(), QStringLiteral("return"))) {
            return asText(outline_.textOf(outline_.main()), ProgramText::tr("the program contains a return"));
        }
        outline_.analyse();
        if (outline_.isPendant()) {
            outline_.foldInstallation();
        }
        for (int pass = 0; pass < kMaxPasses; ++pass) {
            convert();
            if (!keepReferenced()) {
                continue;
            }
            if (countOf(out_.project.programs.find(out_.program)->steps) > project::kMaxProgramSteps) {
                return asText(outline_.textOf(outline_.main()),
                              ProgramText::tr("the program has too many statements"));
            }
            const ProgramScript script = writeScript(out_.project, out_.program);
            if (script.ok()) {
                addNotes(script);
                return isCompiled(script.text)
                           ? Result<ImportedProgram>(out_)
                           : asText(outline_.textOf(outline_.main()),
                                    ProgramText::tr("the script of the steps does not compile"));
            }
            if (!deny(script.problems)) {
                return asText(outline_.textOf(outline_.main()), script.problems.front().text);
            }
        }
        return asText(outline_.textOf(outline_.main()), ProgramText::tr("the program is too complex"));
    }

private:
    void convert() {
        out_ = {};
        out_.project = before_;
        keys_.clear();
        programs_.clear();
        texts_.clear();
        moves_.clear();
        project::Program program;
        program.id = QUuid::createUuid();
        program.name = name_;
        out_.program = program.id;
        program.steps = block(outline_.main());
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
        for (const QString& name : moves_.used()) {
            if (!kept_.contains(name)) {
                omitted_.insert(name);
            }
        }
        for (QSet<QString> missing = QSet<QString>(omitted_).intersect(words); !missing.isEmpty();) {
            QSet<QString> further;
            for (const QString& name : missing) {
                // Skip names omitted only in this pass, because the text of the steps still contains their
                // definitions.
                if (omittedBefore.contains(name)) {
                    kept_.insert(name);
                    omitted_.remove(name);
                    further.unite(wordsOf(moves_.definitions().value(name).first));
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
        const ProgramStep& step = program.steps.front();
        out_.rows = {{0, name_, Row::Result::Text, step.kind, step.id, reason, false}};
        forEachStatement(outline_.main(), false, [&](const ScriptStatement& statement, bool) {
            if (statement.kind == Kind::Disabled || statement.kind == Kind::Omitted) {
                addRow(statement, Row::Result::Omitted, ProgramText::tr("disabled"));
            }
        });
        out_.project.programs.append(std::move(program));
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
            out_.notes << ProgramText::tr(
                "The program uses output integer register 46 or 47, to which Tiller writes the number of the "
                "running step. Use different registers.");
        }
        if (const auto* tool = before_.tooling.tools.find(before_.tooling.activeTool)) {
            out_.notes << ProgramText::tr("In this project, programs begin with the TCP of the tool '%1'.")
                              .arg(tool->name);
        } else if (script.tcp && !callsSetTcp(script.text)) {
            out_.notes << ProgramText::tr(
                              "The program does not set the TCP. Its waypoints require the TCP %1.")
                              .arg(poseText(*script.tcp));
        }
    }

    void addRow(const ScriptStatement& statement, Row::Result result, const ProgramStep& step,
                const QString& reason = {}) {
        addRow(statement, result, reason);
        out_.rows.back().kind = step.kind;
        out_.rows.back().step = step.id;
    }

    void addRow(const ScriptStatement& statement, Row::Result result, const QString& reason) {
        constexpr qsizetype kMaxName = 70;
        QString name = statement.node > 0 ? statement.nodeName : statement.code;
        if (name.isEmpty() && statement.kind == Kind::If) {
            name = QStringLiteral("if ") + statement.branches.front().condition;
        }
        if (name.size() > kMaxName) {
            name = name.left(kMaxName - 1) + QChar(0x2026);
        }
        const int line = outline_.isPendant() ? statement.node : statement.first + 1;
        out_.rows.push_back({line, name, result, {}, {}, reason, false});
    }

    void addText(std::vector<ProgramStep>& steps, const ScriptStatement& statement, const QString& reason) {
        const QString text = outline_.textOf(statement);
        if (callsSetTcp(text)) {
            moves_.setTcpUnknown();
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
        if (!joins || !outline_.isPendant() || statement.node == 0) {
            addRow(statement, Row::Result::Text, steps.back(), reason);
        }
        const auto report = [&](const ScriptStatement& inner, bool) {
            if (inner.kind == Kind::Disabled || inner.kind == Kind::Omitted) {
                addRow(inner, Row::Result::Omitted,
                       ProgramText::tr("a disabled node in a section that is imported as URScript text"));
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
                    addRow(statement, Row::Result::Omitted, statement.code);
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
                        addText(steps, statement, std::exchange(reason_, noStep()));
                    }
                    break;
            }
        }
        return steps;
    }

    void addFolder(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        const bool isNode = statement.node > 0;
        ProgramStep folder = makeStep("folder", {{"name", statement.code}});
        if (isNode) {
            addRow(statement, Row::Result::Step, folder);
        }
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
        while (!outline_.isPendant() && i + 1 < list.size() && list[i + 1].kind == Kind::Comment) {
            texts << list[++i].code;
        }
        addStep(steps, makeStep("comment", {{"text", texts.join(QLatin1Char('\n'))}}), first);
        addRow(first, Row::Result::Step, steps.back());
    }

    void addDisabled(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        const ScriptTcp tcp = moves_.tcp();
        const MoveImport::Definitions definitions = moves_.definitions();
        const std::size_t rows = out_.rows.size();
        std::vector<ProgramStep> disabled = block(statement.body);
        for (ProgramStep& step : disabled) {
            step.disabled = true;
            steps.push_back(std::move(step));
        }
        for (std::size_t row = rows; row < out_.rows.size(); ++row) {
            out_.rows[row].disabled = true;
        }
        moves_.setTcp(tcp);
        moves_.setDefinitions(definitions);
        lastText_ = QUuid();
    }

    bool addConverted(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        reason_ = noStep();
        if (depth_ >= project::kMaxProgramDepth / 2 && statement.kind != Kind::Simple) {
            reason_ = ProgramText::tr("the statement is nested too deeply");
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
                addText(steps, statement, ProgramText::tr("the TCP applies until the end of the program"));
                using TcpKind = ScriptTcp::Kind;
                moves_.setTcp({outline_.functionSetsTcp() ? TcpKind::Unknown : TcpKind::Known, *tcp});
                return true;
            }
            return false;
        }
        addRow(statement, Row::Result::Step, *step);
        addStep(steps, std::move(*step), statement);
        return true;
    }

    std::vector<ProgramStep> innerBlock(const Statements& list, bool repeats) {
        const ScriptTcp before = moves_.tcp();
        bool sets = false;
        forEachStatement(list, false, [&](const ScriptStatement& statement, bool) {
            sets = sets || callsSetTcp(statement.code);
        });
        if (repeats && sets) {
            moves_.setTcpUnknown();
        }
        ++depth_;
        std::vector<ProgramStep> steps = block(list);
        --depth_;
        moves_.setTcp(before);
        if (sets) {
            moves_.setTcpUnknown();
        }
        return steps;
    }

    bool addIf(std::vector<ProgramStep>& steps, const ScriptStatement& statement) {
        const bool allConditions =
            std::all_of(statement.branches.begin(), statement.branches.end(), [](const auto& branch) {
                return branch.condition.isEmpty() || isExpression(withoutBrackets(branch.condition));
            });
        if (!allConditions) {
            reason_ = ProgramText::tr("the condition cannot be used in a step");
            return false;
        }
        addBranches(steps, statement, statement, true);
        return true;
    }

    void addBranches(std::vector<ProgramStep>& steps, const ScriptStatement& chain,
                     const ScriptStatement& statement, bool isFirst) {
        for (const ScriptStatement::Branch& branch : statement.branches) {
            const QString condition = withoutBrackets(branch.condition);
            // The teach pendant writes "else if" as an If inside the Else.
            const ScriptStatement* inner =
                condition.isEmpty() && branch.body.size() == 1 ? &branch.body.front() : nullptr;
            const bool continues =
                inner != nullptr && inner->kind == Kind::If && !denied_.contains(inner->first) &&
                std::all_of(inner->branches.begin(), inner->branches.end(), [](const auto& each) {
                    return each.condition.isEmpty() || isExpression(withoutBrackets(each.condition));
                });
            if (continues) {
                addBranches(steps, chain, *inner, false);
                return;
            }
            ProgramStep step = condition.isEmpty()
                                   ? makeStep("else")
                                   : makeStep(isFirst ? "if" : "elseIf", {{"condition", condition}});
            isFirst = false;
            if (&branch == &statement.branches.front()) {
                addRow(statement, Row::Result::Step, step);
            }
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
            reason_ = ProgramText::tr("the condition cannot be used in a step");
            return false;
        }
        ProgramStep step =
            isEndless ? makeStep("loop", {{"times", 0}}) : makeStep("while", {{"condition", condition}});
        addRow(statement, Row::Result::Step, step);
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
        addRow(statement, Row::Result::Step, step);
        addStep(steps, std::move(step), statement);
        return true;
    }

    /// Converts a While loop and its counter to a Loop step, if the counter is only used to count the
    /// iterations.
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
            !increment.match(loop.body.back().code).hasMatch() || outline_.occurrences(counter) != kUses ||
            hasWord(loop.body, QStringLiteral("continue"))) {
            return false;
        }
        ProgramStep step = makeStep("loop", {{"times", times}});
        addRow(loop, Row::Result::Step, step);
        step.steps = innerBlock(Statements(loop.body.begin(), loop.body.end() - 1), true);
        addStep(steps, std::move(step), list[i]);
        return true;
    }

    /// Converts statements that the teach pendant has written for a Switch node.
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
        if (outline_.occurrences(match.captured(1)) != conditions + 1) {
            return false;
        }
        ProgramStep step = makeStep("switch", {{"value", match.captured(2)}});
        addRow(list[i], Row::Result::Step, step);
        for (std::size_t at = 0; at < cases.branches.size(); ++at) {
            const QString& wanted = values[static_cast<qsizetype>(at)];
            ProgramStep part = wanted.isEmpty() ? makeStep("default") : makeStep("case", {{"value", wanted}});
            part.steps = innerBlock(cases.branches[at].body, false);
            addStep(step.steps, std::move(part), list[i]);
        }
        addStep(steps, std::move(step), list[i]);
        return true;
    }

    /// Converts a function without parameters, which is only called as a statement, to a program.
    bool addFunction(const ScriptStatement& statement) {
        static const QRegularExpression def(QStringLiteral("^def\\s+(\\w+)\\s*\\(\\s*\\)\\s*:$"));
        const auto match = def.match(statement.code);
        if (!match.hasMatch() || keptFunctions_.contains(match.captured(1)) ||
            hasWord(statement.body, QStringLiteral("return"))) {
            reason_ = ProgramText::tr(
                "no step corresponds to a thread, or to a function with parameters or a result");
            return false;
        }
        const QString name = match.captured(1);
        if (outline_.occurrences(name) < 2) {
            reason_ = ProgramText::tr("the program does not call this function");
            return false;
        }
        addRow(statement, Row::Result::Step, ProgramText::tr("imported as a program"));
        out_.rows.back().kind = QStringLiteral("call");
        const ScriptTcp tcp = moves_.tcp();
        if (callsSetTcpAfter(statement.last)) {
            moves_.setTcpUnknown();
        }
        project::Program program;
        program.id = QUuid::createUuid();
        program.name = out_.project.programs.uniqueName(name_ + QStringLiteral(": ") + name);
        program.steps = block(statement.body);
        addTexts(program.steps);
        moves_.setTcp(tcp);
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

    /// Returns  true if the statement only defines a position that has become a waypoint
    bool takeDefinition(const ScriptStatement& statement) {
        static const QRegularExpression global(QStringLiteral("^global\\s+(\\w+)\\s*=(?!=)\\s*(.+)$"));
        const auto match = global.match(statement.code);
        const QString name = match.captured(1);
        if (!match.hasMatch() || !outline_.isConstant(name)) {
            return false;
        }
        moves_.define(name, match.captured(2).trimmed());
        if (omitted_.contains(name)) {
            addRow(statement, Row::Result::Merged, ProgramText::tr("part of a waypoint"));
            return true;
        }
        return false;
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
        const QString label = statement.node > 0 ? statement.nodeName : QString();
        return MoveImport::isMove(*call) ? moves_.step(*call, label, reason_)
                                         : stepForCall(*call, out_.project.tooling.payloads, reason_);
    }

    std::optional<ProgramStep> assignStep(const QString& name, const QString& value) {
        static const QRegularExpression request(
            QStringLiteral("^request_(boolean|integer|float|string)_from_primary_client$"));
        const auto call = parseCall(value);
        const QString type = outline_.types().value(name);
        if (type.isEmpty()) {
            reason_ = ProgramText::tr("the type or the scope of the variable cannot be determined");
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

    const project::Project& before_;
    const QString name_;
    const QStringList& lines_;
    ScriptOutline outline_{lines_};
    // decisions of earlier passes
    QHash<int, QString> denied_;  ///< statements that must be text, with the reason
    QSet<QString> omitted_;       ///< definitions that are part of waypoints
    QSet<QString> kept_;          ///< definitions that the text uses
    QSet<QString> keptFunctions_;
    // state of a pass
    ImportedProgram out_;
    QHash<QUuid, int> keys_;  ///< first line of the statement of each step
    QHash<QString, QUuid> programs_;
    MoveImport moves_{before_, out_, name_, outline_.types()};
    QString reason_;
    QHash<QUuid, QStringList> texts_;  ///< texts of the text steps
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
