namespace Msisf.App.Preview;

/// <summary>The digital numbers that a detector is expected to give for the lit ground of an image.</summary>
/// <param name="Median">DN.</param>
/// <param name="High">DN: 99 % of the lit ground have no more.</param>
internal readonly record struct SignalLevels(int Median, int High);
