namespace Msisf.Stress.Fuzz;

/// <summary>A kind of input that is damaged.</summary>
internal interface IFuzzTarget
{
    /// <summary>For the report, e.g. "batch files".</summary>
    string Name { get; }

    /// <summary>Writes what a call needs, one thing of it damaged.</summary>
    /// <param name="folder">Existing and empty.</param>
    /// <param name="random">Draws the damage.</param>
    /// <param name="isDamaged">False leaves all as it was, to see that it is right then.</param>
    FuzzCase Make(string folder, CaseRandom random, bool isDamaged);
}
