namespace Msisf.App.Settings;

/// <summary>The form in which <c>--dry-run</c> prints.</summary>
internal enum PreviewFormat
{
    /// <summary>Aligned columns with few digits, for people.</summary>
    Table,

    /// <summary>Comma-separated values with a header and all digits.</summary>
    Csv,

    /// <summary>An array of objects with all digits.</summary>
    Json,
}
