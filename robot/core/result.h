// SPDX-License-Identifier: MIT
#pragma once

// A value or an error. Accessing the value of a failed result violates a precondition.

#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "robot/core/error.h"

namespace tiller {

/// Thrown by value() of a failed result. what() returns Error::message().
class ResultError : public std::logic_error {
public:
    explicit ResultError(Error error) : std::logic_error(error.message()), error_(std::move(error)) {}
    const Error& error() const noexcept { return error_; }   ///< Code, context and message.
    ErrorCode code() const noexcept { return error_.code; }  ///< Like error().code.

private:
    Error error_;
};

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit by intent
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit by intent

    bool ok() const { return content_.index() == 0; }  ///< True if there is a value.
    explicit operator bool() const { return ok(); }

    /// Throws ResultError on a failed result.
    const T& value() const& { return checked(), std::get<0>(content_); }
    T& value() & { return checked(), std::get<0>(content_); }  ///< Errors   ResultError on a failed result
    /// Moves the value out.
    /// Errors   ResultError on a failed result
    T&& value() && { return checked(), std::get<0>(std::move(content_)); }
    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }

    /// The error; code None for a successful result.
    Error error() const { return ok() ? Error{} : std::get<1>(content_); }

private:
    void checked() const {
        if (!ok()) {
            throw ResultError(std::get<1>(content_));
        }
    }
    std::variant<T, Error> content_;
};

template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}  // NOLINT: implicit by intent

    bool ok() const { return !error_.has_value(); }  ///< True if there is no error.
    explicit operator bool() const { return ok(); }
    /// Throws ResultError on a failed result; otherwise does nothing.
    void value() const {
        if (!ok()) {
            throw ResultError(*error_);
        }
    }
    /// The error; code None for a successful result.
    Error error() const { return error_.value_or(Error{}); }

private:
    std::optional<Error> error_;
};

}  // namespace tiller
