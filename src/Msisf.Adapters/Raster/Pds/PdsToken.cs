namespace Msisf.Adapters.Raster.Pds;

/// <summary>What a piece of a PDS3 label is.</summary>
internal enum PdsTokenKind
{
    /// <summary>A keyword or an unquoted value.</summary>
    Word,

    /// <summary>A value in double or single quotes.</summary>
    Quoted,

    /// <summary>A unit in angle brackets.</summary>
    Unit,

    /// <summary>One of = ( ) { } and the comma.</summary>
    Sign,

    /// <summary>The end of the text.</summary>
    End,
}

/// <summary>A piece of a PDS3 label.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Text">Its text, without quotes or brackets.</param>
/// <param name="Line">Line of its first character, from 1.</param>
internal readonly record struct PdsToken(PdsTokenKind Kind, string Text, int Line)
{
    /// <summary>It is this sign.</summary>
    public bool IsSign(string sign) => Kind == PdsTokenKind.Sign && Text == sign;
}
