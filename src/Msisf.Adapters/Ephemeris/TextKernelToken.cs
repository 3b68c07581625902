namespace Msisf.Adapters.Ephemeris;

/// <summary>The kind of a token.</summary>
internal enum TextKernelTokenKind
{
    /// <summary>A name, a number or a date.</summary>
    Word,

    /// <summary>A text in quotes, without them.</summary>
    Text,

    /// <summary>=</summary>
    Assign,

    /// <summary>+=</summary>
    Append,

    /// <summary>(</summary>
    Open,

    /// <summary>)</summary>
    Close,
}

/// <summary>A token of a text kernel's data. A class, because lists of it need no compilation at start-up.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Value">Its characters; a text's without quotes.</param>
/// <param name="Line">Its line in the file, from 1.</param>
internal sealed record TextKernelToken(TextKernelTokenKind Kind, string Value, int Line);
