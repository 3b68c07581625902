namespace Msisf.Stress;

/// <summary>How much is tried.</summary>
public enum StressLength
{
    /// <summary>Some seconds, for every day.</summary>
    Everyday,

    /// <summary>What the documents state.</summary>
    Full,
}
