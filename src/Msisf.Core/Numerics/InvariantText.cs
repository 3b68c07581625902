using System.Runtime.CompilerServices;

namespace Msisf.Core.Numerics;

/// <summary>Text with numbers as files and messages have them, whatever the culture of the machine; known in all sources.</summary>
public static class InvariantText
{
    /// <summary>An interpolated string, or several with + between them, in the invariant culture.</summary>
    public static string Invariant(ref InvariantStringHandler text) => text.ToStringAndClear();
}

/// <summary>The parts of an interpolated string as the compiler gives them to <see cref="InvariantText.Invariant"/>.</summary>
[InterpolatedStringHandler]
public ref struct InvariantStringHandler(int literalLength, int formattedCount)
{
    private DefaultInterpolatedStringHandler _text = new(literalLength, formattedCount, CultureInfo.InvariantCulture);

    /// <summary>Text between the values.</summary>
    public void AppendLiteral(string text) => _text.AppendLiteral(text);

    /// <summary>A text among the values.</summary>
    public void AppendFormatted(string? value) => _text.AppendFormatted(value);

    /// <summary>A part of a text among the values.</summary>
    public void AppendFormatted(ReadOnlySpan<char> value) => _text.AppendFormatted(value);

    /// <summary>A value, with its format.</summary>
    public void AppendFormatted<T>(T value, string? format = null) => _text.AppendFormatted(value, format);

    /// <summary>A value in a column of some width, with its format.</summary>
    public void AppendFormatted<T>(T value, int alignment, string? format = null) => _text.AppendFormatted(value, alignment, format);

    internal string ToStringAndClear() => _text.ToStringAndClear();
}
