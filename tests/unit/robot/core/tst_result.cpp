// SPDX-License-Identifier: MIT
#include <QSet>
#include <QTest>
#include <memory>
#include <stdexcept>

#include "robot/core/result.h"

using namespace tiller;

class TestResult : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void valueIsReturned() {
        Result<int> result(42);
        QVERIFY(result.ok());
        QVERIFY(static_cast<bool>(result));
        QCOMPARE(*result, 42);
        QVERIFY(result.error().code == ErrorCode::None);
        *result = 43;
        QCOMPARE(result.value(), 43);
    }

    void errorIsReturned() {
        const Result<int> result(Error{ErrorCode::Timeout, "read", ""});
        QVERIFY(!result.ok());
        QVERIFY(result.error().code == ErrorCode::Timeout);
        QCOMPARE(result.error().context, QString("read"));
    }

    void valueOfAFailureViolatesThePrecondition() {
        const Result<int> result(Error{ErrorCode::Timeout, "read", ""});
        QVERIFY_EXCEPTION_THROWN((void)result.value(), std::logic_error);
    }

    void theExceptionOfAFailureContainsItsError() {
        const auto caught = [](const auto& result) {
            try {
                (void)result.value();
            } catch (const ResultError& error) {
                return error;
            }
            return ResultError({});
        };
        const Error refused{ErrorCode::ConnectionRefused, "connect", "no"};
        QCOMPARE(caught(Result<int>(refused)).code(), ErrorCode::ConnectionRefused);
        QCOMPARE(caught(Result<void>(refused)).error().context, QString("connect"));
        QCOMPARE(caught(Result<void>(refused)).what(), "ConnectionRefused: connect (no)");
    }

    void aMoveOnlyValueCanBeMovedOut() {
        Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
        const std::unique_ptr<int> taken = std::move(result).value();
        QCOMPARE(*taken, 7);
    }

    void aVoidResultIsOkByDefault() {
        const Result<void> good;
        QVERIFY(good.ok());
        QVERIFY(good.error().code == ErrorCode::None);
        const Result<void> bad(Error{ErrorCode::DiskFull, "write", ""});
        QVERIFY(!bad);
        QVERIFY(bad.error().code == ErrorCode::DiskFull);
    }

    void errorTextIsOneLine() {
        const Error error{ErrorCode::ConnectionRefused, "connect to 192.168.0.10:30004",
                          "Connection refused"};
        QCOMPARE(error.toString(),
                 QString("ConnectionRefused: connect to 192.168.0.10:30004 (Connection refused)"));
        QCOMPARE((Error{ErrorCode::Timeout, "", ""}).toString(), QString("Timeout"));
    }

    void everyCodeHasItsOwnName() {
        QSet<QString> names;
        const int last = static_cast<int>(ErrorCode::Internal);
        for (int code = 0; code <= last; ++code) {
            names.insert(errorCodeName(static_cast<ErrorCode>(code)));
        }
        QCOMPARE(names.size(), last + 1);
    }
};

QTEST_GUILESS_MAIN(TestResult)
#include "tst_result.moc"
