namespace Msisf.Benchmarks.Programs;

/// <summary>Whose memory is looked at while a program runs.</summary>
internal enum MemoryWatch
{
    /// <summary>Nobody's: looking would disturb a run of a fraction of a second.</summary>
    None,

    /// <summary>The program's, twice a second.</summary>
    Own,

    /// <summary>That of the programs that it starts (POV-Ray), often enough not to miss the peak of a run of seconds.</summary>
    Children,
}
