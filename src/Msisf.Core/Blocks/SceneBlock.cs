namespace Msisf.Core.Blocks;

/// <summary>
/// A piece of a surface that a scene includes as one mesh: a square of cells of a model, or some facets of the seams between models.
/// </summary>
/// <param name="Part">Number of the model; the number of models stands for the seams.</param>
/// <param name="Row">Row of the square from the top; 0 for seams.</param>
/// <param name="Column">Column of the square from the left; of seams their number.</param>
public readonly record struct SceneBlock(int Part, int Row, int Column) : IComparable<SceneBlock>
{
    /// <summary>By model, then place.</summary>
    public int CompareTo(SceneBlock other) => (Part, Row, Column).CompareTo((other.Part, other.Row, other.Column));

    /// <summary>Order by model, then place.</summary>
    public static bool operator <(SceneBlock a, SceneBlock b) => a.CompareTo(b) < 0;

    /// <summary>Order by model, then place.</summary>
    public static bool operator <=(SceneBlock a, SceneBlock b) => a.CompareTo(b) <= 0;

    /// <summary>Order by model, then place.</summary>
    public static bool operator >(SceneBlock a, SceneBlock b) => a.CompareTo(b) > 0;

    /// <summary>Order by model, then place.</summary>
    public static bool operator >=(SceneBlock a, SceneBlock b) => a.CompareTo(b) >= 0;
}
